#include "core/plain_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "core/utf8.hpp"

namespace pathrace {
namespace {

bool is_control(std::uint32_t code) {
  const bool c0_or_c1 = code < 0x20 || (code >= 0x7F && code < 0xA0);
  const bool separator = code == 0x2028 || code == 0x2029;
  const bool invisible = code == 0x200B || code == 0xFEFF;  // zero width
  const bool direction = code == 0x200E || code == 0x200F || (code >= 0x202A && code <= 0x202E) ||
                         (code >= 0x2066 && code <= 0x2069);
  return c0_or_c1 || separator || invisible || direction;
}

// Bytes of the plain letter that the text begins with; 0 when it begins with none.
std::size_t plain_size(std::string_view text) {
  const std::size_t size = letter_size(text);
  return size > 0 && !is_control(code_point(text, size)) ? size : 0;
}

}  // namespace

bool is_plain_text(std::string_view text) {
  while (!text.empty()) {
    const std::size_t size = plain_size(text);
    if (size == 0) return false;
    text.remove_prefix(size);
  }
  return true;
}

std::string escape_controls(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::size_t plain = plain_size(text);
    if (plain > 0) {
      result += text.substr(0, plain);
    } else {
      result += fmt::format("\\x{:02x}", static_cast<unsigned>(static_cast<unsigned char>(text.front())));
    }
    text.remove_prefix(std::max<std::size_t>(1, plain));
  }
  return result;
}

void require_plain_name(std::string_view where, std::string_view what, std::string_view name) {
  if (is_plain_text(name)) return;
  throw InputError(fmt::format("{}{}{} '{}'; expected a name without control characters",
                               escape_controls(where), where.empty() ? "" : ": ", what,
                               escape_controls(name)));
}

}  // namespace pathrace
