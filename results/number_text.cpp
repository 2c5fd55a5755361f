#include "results/number_text.hpp"

#include <fmt/format.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <iterator>

#include "core/error.hpp"
#include "core/hash.hpp"
#include "results/quote.hpp"

namespace pathrace::results {
namespace {

constexpr std::string_view nan_prefix = "nan:";

template <typename Number>
bool read_whole(std::string_view text, Number& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc{} && end == text.data() + text.size();
}

}  // namespace

void append_number(std::string& text, double value) {
  if (std::isnan(value)) {
    text += nan_prefix;
    text += hex(std::bit_cast<std::uint64_t>(value));
  } else {
    fmt::format_to(std::back_inserter(text), "{}", value);
  }
}

std::string print_number(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

double parse_number(std::string_view text) {
  if (text.substr(0, nan_prefix.size()) == nan_prefix) {
    const double value = std::bit_cast<double>(parse_hex(text.substr(nan_prefix.size())));
    if (std::isnan(value)) return value;
  }
  double value = 0;
  if (!read_whole(text, value)) throw InputError(fmt::format("expected a number, got {}", quoted(text)));
  return value;
}

std::uint64_t parse_count(std::string_view text) {
  std::uint64_t value = 0;
  if (!read_whole(text, value)) throw InputError(fmt::format("expected a count, got {}", quoted(text)));
  return value;
}

std::uint64_t parse_hex(std::string_view text) {
  std::uint64_t value = 0;
  bool good = text.size() == 16;
  for (const char digit : text) {
    const bool decimal = digit >= '0' && digit <= '9';
    good = good && (decimal || (digit >= 'a' && digit <= 'f'));
    value = value << 4 | static_cast<std::uint64_t>(decimal ? digit - '0' : digit - 'a' + 10);
  }
  if (!good) {
    throw InputError(fmt::format("expected 16 lower-case hexadecimal digits, got {}", quoted(text)));
  }
  return value;
}

}  // namespace pathrace::results
