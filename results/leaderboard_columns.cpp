#include "results/leaderboard_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pathrace::results {
namespace {

using Value = std::optional<double> Standing::*;

constexpr const char* missing = "-";  // on the console

std::string exact(double value) {
  return fmt::format("{}", value);
}

template <Value member>
std::string csv(const Standing& standing) {
  return standing.*member ? exact(*(standing.*member)) : "";
}

template <std::uint64_t Standing::*member>
std::string number(const Standing& standing) {
  return std::to_string(standing.*member);
}

template <Value member>
std::string percent(const Standing& standing) {
  return standing.*member ? fmt::format("{:.2f}%", *(standing.*member) * 100) : missing;
}

template <Value member, int decimals>
std::string decimal(const Standing& standing) {
  return standing.*member ? fmt::format("{:.{}f}", *(standing.*member), decimals) : missing;
}

/// Three digits or all before the point, whichever is more.
template <Value member>
std::string three_digits(const Standing& standing) {
  if (!(standing.*member)) return missing;
  const double value = *(standing.*member);
  const int magnitude = value > 0 ? static_cast<int>(std::floor(std::log10(value))) : 0;
  return fmt::format("{:.{}f}", value, std::clamp(2 - magnitude, 0, 6));
}

/// Counts, whose median may end in a half.
template <Value member>
std::string count(const Standing& standing) {
  return standing.*member
             ? fmt::format("{:.{}f}", *(standing.*member), std::fmod(*(standing.*member), 1) == 0 ? 0 : 1)
             : missing;
}

std::string rank(const Standing& standing) {
  return std::to_string(standing.rank);
}
std::string planner(const Standing& standing) {
  return standing.planner;
}
std::string track(const Standing& standing) {
  return std::string(name(standing.track));
}
std::string success(const Standing& standing) {
  return exact(standing.success);
}
std::string success_percent(const Standing& standing) {
  return fmt::format("{:.1f}%", standing.success * 100);
}
std::string time_pass(const Standing& standing) {
  return standing.crowded ? "crowded" : "alone";
}
std::string time_mark(const Standing& standing) {
  return three_digits<&Standing::time_ms_median>(standing) + (standing.crowded ? "~" : " ");
}

}  // namespace

const std::vector<LeaderboardColumn>& leaderboard_columns() {
  using S = Standing;
  using Table = LeaderboardColumn::Table;
  constexpr auto both = Table::both;
  constexpr auto paths = Table::paths;
  constexpr auto runs = Table::runs;
  constexpr auto failures = Table::where_not_zero;
  static const std::vector<LeaderboardColumn> columns = {
      {"rank", rank, "rank", rank},
      {"planner", planner, "planner", planner, 0, both, true},
      {"track", track, "", nullptr},
      {"trials", number<&S::trials>, "trials", number<&S::trials>, 1},
      {"solved", number<&S::solved>, "solved", number<&S::solved>, 9},
      {"success", success, "success", success_percent},
      {"gap_median", csv<&S::gap_median>, "gap", percent<&S::gap_median>},
      {"gap_solved", csv<&S::gap_solved>, "gap solved", percent<&S::gap_solved>, 2},
      {"length_median", csv<&S::length_median>, "length", decimal<&S::length_median, 2>, 10},
      {"turns_median", csv<&S::turns_median>, "turns", count<&S::turns_median>, 11, paths},
      {"evaluations_median", csv<&S::evaluations_median>, "evaluations", count<&S::evaluations_median>, 7},
      {"checks_median", csv<&S::checks_median>, "checks", count<&S::checks_median>, 3},
      {"time_ms_median", csv<&S::time_ms_median>, "ms ", time_mark},
      {"time_pass", time_pass, "", nullptr},
      {"steps_median", csv<&S::steps_median>, "steps", count<&S::steps_median>, 4, runs},
      {"collisions_mean", csv<&S::collisions_mean>, "collisions", decimal<&S::collisions_mean, 2>, 5, runs},
      {"struck_mean", csv<&S::struck_mean>, "struck", decimal<&S::struck_mean, 2>, 6, runs},
      {"min_clearance_median", csv<&S::min_clearance_median>, "clearance",
       decimal<&S::min_clearance_median, 2>, 8, runs},
      {"oscillations_median", csv<&S::oscillations_median>, "oscillations", count<&S::oscillations_median>,
       13, runs},
      {"step_ms_median", csv<&S::step_ms_median>, "ms/step", three_digits<&S::step_ms_median>, 12, runs},
      {"step_ms_p99_median", csv<&S::step_ms_p99_median>, "p99", three_digits<&S::step_ms_p99_median>, 14,
       runs},
      {"gave_up", number<&S::gave_up>, "gave up", number<&S::gave_up>, 0, failures},
      {"crashed", number<&S::crashed>, "crashed", number<&S::crashed>, 0, failures},
      {"invalid", number<&S::invalid>, "invalid", number<&S::invalid>, 0, failures},
  };
  return columns;
}

}  // namespace pathrace::results
