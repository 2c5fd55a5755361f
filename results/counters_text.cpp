#include "results/counters_text.hpp"

#include <fmt/format.h>

#include <iterator>

#include "core/error.hpp"
#include "results/number_text.hpp"
#include "results/quote.hpp"
#include "results/split.hpp"

namespace pathrace::results {
namespace {

Counter parse_counter(std::string_view text) {
  const std::size_t equals = text.find('=');
  if (equals == 0 || equals == std::string_view::npos) {
    throw InputError(fmt::format("expected a counter 'name=value', got {}", quoted(text)));
  }
  return {std::string(text.substr(0, equals)), parse_count(text.substr(equals + 1))};
}

}  // namespace

std::string print_counters(const std::vector<Counter>& counters) {
  std::string text;
  for (const Counter& counter : counters) {
    if (!text.empty()) text += ' ';
    fmt::format_to(std::back_inserter(text), "{}={}", counter.name, counter.value);
  }
  return text;
}

std::vector<Counter> parse_counters(std::string_view text) {
  std::vector<Counter> counters;
  for_each_piece(text, ' ', [&](std::string_view piece) { counters.push_back(parse_counter(piece)); });
  return counters;
}

}  // namespace pathrace::results
