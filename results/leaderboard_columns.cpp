#include "results/leaderboard_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pathrace::results {
namespace {

using Value = std::optional<double> Standing::*;

constexpr const char* missing = "-";

std::string exact(double value) {
  return fmt::format("{}", value);
}

template <Value member>
std::string csv(const Standing& standing) {
  return standing.*member ? exact(*(standing.*member)) : missing;
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
std::string trials(const Standing& standing) {
  return std::to_string(standing.trials);
}
std::string solved(const Standing& standing) {
  return std::to_string(standing.solved);
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
  using Block = LeaderboardColumn::Block;
  static const std::vector<LeaderboardColumn> columns = {
      {"rank", rank, "rank", rank},
      {"planner", planner, "planner", planner, true},
      {"track", track, "track", track, true},
      {"trials", trials, "trials", trials},
      {"solved", solved, "solved", solved},
      {"success", success, "success", success_percent},
      {"gap_median", csv<&Standing::gap_median>, "gap", percent<&Standing::gap_median>},
      {"gap_solved", csv<&Standing::gap_solved>, "gap solved", percent<&Standing::gap_solved>},
      {"length_median", csv<&Standing::length_median>, "length", decimal<&Standing::length_median, 2>},
      {"turns_median", csv<&Standing::turns_median>, "turns", count<&Standing::turns_median>, false,
       Block::paths},
      {"evaluations_median", csv<&Standing::evaluations_median>, "evaluations",
       count<&Standing::evaluations_median>},
      {"checks_median", csv<&Standing::checks_median>, "checks", count<&Standing::checks_median>},
      {"time_ms_median", csv<&Standing::time_ms_median>, "ms ", time_mark},
      {"time_pass", time_pass, "", nullptr},
      {"steps_median", csv<&Standing::steps_median>, "steps", count<&Standing::steps_median>, false,
       Block::runs},
      {"collisions_mean", csv<&Standing::collisions_mean>, "collisions",
       decimal<&Standing::collisions_mean, 2>, false, Block::runs},
      {"struck_mean", csv<&Standing::struck_mean>, "struck", decimal<&Standing::struck_mean, 2>, false,
       Block::runs},
      {"min_clearance_median", csv<&Standing::min_clearance_median>, "clearance",
       decimal<&Standing::min_clearance_median, 2>, false, Block::runs},
      {"oscillations_median", csv<&Standing::oscillations_median>, "oscillations",
       count<&Standing::oscillations_median>, false, Block::runs},
      {"step_ms_median", csv<&Standing::step_ms_median>, "ms/step", three_digits<&Standing::step_ms_median>,
       false, Block::runs},
      {"step_ms_p99_median", csv<&Standing::step_ms_p99_median>, "p99",
       three_digits<&Standing::step_ms_p99_median>, false, Block::runs},
  };
  return columns;
}

}  // namespace pathrace::results
