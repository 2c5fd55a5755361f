#include "results/trace_text.hpp"

#include <fmt/format.h>

#include <array>
#include <iterator>

#include "core/error.hpp"
#include "results/number_text.hpp"
#include "results/quote.hpp"
#include "results/split.hpp"

namespace pathrace::results {
namespace {

TracePoint parse_trace_point(std::string_view text) {
  std::array<std::string_view, 5> pieces;
  std::size_t count = 0;
  for_each_piece(text, ',', [&](std::string_view piece) {
    if (count < pieces.size()) pieces[count] = piece;
    ++count;
  });
  if (count != pieces.size()) {
    throw InputError(fmt::format("expected a trace point 'evaluations,iterations,checks,wall_s,cost', got {}",
                                 quoted(text)));
  }
  return {{parse_count(pieces[0]), parse_count(pieces[1]), parse_count(pieces[2])},
          parse_number(pieces[3]),
          parse_number(pieces[4])};
}

}  // namespace

std::string print_trace(const std::vector<TracePoint>& trace) {
  std::string text;
  for (const TracePoint& point : trace) {
    if (!text.empty()) text += ' ';
    fmt::format_to(std::back_inserter(text), "{},{},{},", point.work.evaluations, point.work.iterations,
                   point.work.checks);
    append_number(text, point.wall_s);
    text += ',';
    append_number(text, point.cost);
  }
  return text;
}

std::vector<TracePoint> parse_trace(std::string_view text) {
  std::vector<TracePoint> trace;
  for_each_piece(text, ' ', [&](std::string_view piece) { trace.push_back(parse_trace_point(piece)); });
  return trace;
}

}  // namespace pathrace::results
