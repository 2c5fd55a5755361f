#include "core/utf8.hpp"

#include <algorithm>

namespace pathrace {
namespace {

std::uint32_t byte_at(std::string_view text, std::size_t i) {
  return static_cast<unsigned char>(text[i]);
}

// What the first byte promises.
std::size_t promised_size(std::uint32_t first) {
  if (first < 0x80) return 1;
  if (first >= 0xC2 && first < 0xE0) return 2;
  if (first >= 0xE0 && first < 0xF0) return 3;
  return first >= 0xF0 && first < 0xF5 ? 4 : 0;
}

// Too long a spelling, half of a surrogate pair, above U+10FFFF, or no character at all (U+FFFE, U+FFFF).
bool forbidden(std::uint32_t code, std::size_t size) {
  return (size == 3 && code < 0x800) || (size == 4 && code < 0x10000) || code > 0x10FFFF ||
         (code >= 0xD800 && code < 0xE000) || code == 0xFFFE || code == 0xFFFF;
}

}  // namespace

std::size_t letter_size(std::string_view text) {
  if (text.empty()) return 0;
  const std::size_t size = promised_size(byte_at(text, 0));
  if (size <= 1 || size > text.size()) return size == 1 ? 1 : 0;
  for (std::size_t i = 1; i < size; ++i) {
    if ((byte_at(text, i) & 0xC0U) != 0x80U) return 0;
  }
  return forbidden(code_point(text, size), size) ? 0 : size;
}

std::uint32_t code_point(std::string_view text, std::size_t size) {
  if (size == 1) return byte_at(text, 0);
  std::uint32_t code = byte_at(text, 0) & (0x7FU >> size);
  for (std::size_t i = 1; i < size; ++i) code = (code << 6) | (byte_at(text, i) & 0x3FU);
  return code;
}

std::size_t letter_count(std::string_view text) {
  std::size_t count = 0;
  for (; !text.empty(); ++count) text.remove_prefix(std::max<std::size_t>(1, letter_size(text)));
  return count;
}

std::string shortened(std::string_view text, std::size_t letters) {
  const std::size_t count = letter_count(text);
  if (count <= letters) return std::string(text);
  const auto from = [text](std::size_t letter) {
    std::string_view rest = text;
    for (; letter > 0; --letter) rest.remove_prefix(std::max<std::size_t>(1, letter_size(rest)));
    return rest;
  };
  const std::size_t head = letters / 2;
  const std::size_t tail = letters - 1 - head;
  const std::string_view begin = text.substr(0, text.size() - from(head).size());
  return std::string(begin) + "\u2026" + std::string(from(count - tail));
}

}  // namespace pathrace
