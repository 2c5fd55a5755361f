#include "results/trace_csv.hpp"

#include "results/csv.hpp"
#include "results/number_text.hpp"

namespace pathrace::results {

void write_trace_csv(std::ostream& out, const std::vector<TracePoint>& trace) {
  write_csv_line(out, {"evaluations", "iterations", "checks", "wall_s", "length"});
  for (const TracePoint& point : trace) {
    write_csv_line(out,
                   {std::to_string(point.work.evaluations), std::to_string(point.work.iterations),
                    std::to_string(point.work.checks), print_number(point.wall_s), print_number(point.cost)});
  }
}

}  // namespace pathrace::results
