#include "scenarios/text.hpp"

#include <fmt/format.h>

#include <charconv>

#include "core/error.hpp"
#include "core/grid.hpp"
#include "core/plain_text.hpp"

namespace pathrace::scenarios {
namespace {

constexpr std::string_view blanks = " \t\r\n";
constexpr std::size_t longest_value = 40;

std::string escaped(unsigned char byte) {
  return fmt::format("\\x{:02x}", static_cast<unsigned>(byte));
}

bool is_control(unsigned char byte) {
  return byte < 0x20 || byte == 0x7f;
}

template <typename Number>
std::optional<Number> number_of(std::string_view text) {
  Number value{};
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stop != end) return std::nullopt;
  return value;
}

}  // namespace

std::string printable(std::string_view value) {
  std::string result;
  for (const char character : value) {
    const auto byte = static_cast<unsigned char>(character);
    const std::string piece = is_control(byte) || byte > 0x7e ? escaped(byte) : std::string(1, character);
    if (result.size() + piece.size() > longest_value) return result + "...";
    result += piece;
  }
  return result;
}

std::string printable_name(std::string_view name) {
  return escape_controls(name);
}

void fail_at(std::string_view name, int line, std::string_view what) {
  throw InputError(fmt::format("{}:{}: {}", printable_name(name), line, what));
}

void fail_in(std::string_view name, std::string_view what) {
  throw InputError(fmt::format("{}: {}", printable_name(name), what));
}

void require_map_size(std::string_view name, int line, std::int64_t width, std::int64_t height) {
  constexpr int side = OccupancyGrid::max_side;
  const bool sides_fit = width >= 1 && height >= 1 && width <= side && height <= side;
  if (sides_fit && width * height <= OccupancyGrid::max_cells) return;
  const std::string what = fmt::format("a map of {}x{} cells; expected 1 to {} a side and at most {} in all",
                                       width, height, side, OccupancyGrid::max_cells);
  if (line == 0) fail_in(name, what);
  fail_at(name, line, what);
}

std::string_view text_of(std::string_view bytes, std::string_view name) {
  constexpr std::string_view utf8_mark = "\xef\xbb\xbf";
  if (bytes.starts_with(utf8_mark)) return bytes.substr(utf8_mark.size());
  const auto zero = [&](std::size_t i) { return bytes[i] == '\0'; };
  const bool alternates = bytes.size() >= 4 && zero(0) == zero(2) && zero(1) == zero(3) && zero(0) != zero(1);
  if (alternates || bytes.starts_with("\xff\xfe") || bytes.starts_with("\xfe\xff")) {
    fail_at(name, 1, "UTF-16 text; expected UTF-8: save the file as that");
  }
  return bytes;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::vector<std::string_view> split_at(std::string_view text, char separator) {
  std::vector<std::string_view> pieces;
  while (true) {
    const std::size_t end = text.find(separator);
    pieces.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return pieces;
    text.remove_prefix(end + 1);
  }
}

std::vector<std::string_view> split_at_blanks(std::string_view text) {
  std::vector<std::string_view> words;
  for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
    words.push_back(text.substr(0, text.find_first_of(blanks)));
    text.remove_prefix(words.back().size());
  }
  return words;
}

std::optional<int> whole_number(std::string_view text) {
  return number_of<int>(text);
}

std::optional<double> real_number(std::string_view text) {
  return number_of<double>(text);
}

Lines::Lines(std::string_view text) : ending_(text.find('\n') == std::string_view::npos ? '\r' : '\n') {
  const std::size_t last = text.find_last_not_of(blanks);
  rest_ = last == std::string_view::npos ? std::string_view{} : text.substr(0, last + 1);
}

std::optional<std::string_view> Lines::next() {
  ++number_;
  if (rest_.empty()) return std::nullopt;
  const std::size_t end = rest_.find(ending_);
  std::string_view line = rest_.substr(0, end);
  rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

}  // namespace pathrace::scenarios
