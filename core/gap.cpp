#include "core/gap.hpp"

#include <fmt/format.h>

namespace pathrace {
namespace {

bool is_proven(const Scenario& scenario, Track track) {
  switch (track) {
    case Track::lattice: return scenario.optimum.proven;
    case Track::any_angle: return scenario.any_angle_optimum.proven;
    case Track::dynamic: return false;
  }
  return false;
}

}  // namespace

std::optional<double> gap(const PathMetrics& metrics, const Optimum& optimum) {
  if (!metrics.lattice || !optimum.length) return std::nullopt;
  if (*metrics.lattice == *optimum.length) return 0.0;
  const double best = optimum.length->value();
  if (best == 0) return std::nullopt;
  return metrics.length / best - 1;
}

std::optional<double> gap(const PathMetrics& metrics, const AnyAngleOptimum& optimum) {
  if (!optimum.length) return std::nullopt;
  const double best = *optimum.length;
  const double excess = metrics.length - best;
  if (excess <= any_angle_rounding * best && excess >= -any_angle_rounding * best) return 0.0;
  if (best == 0) return std::nullopt;
  return metrics.length / best - 1;
}

std::optional<double> gap(const PathMetrics& metrics, const Scenario& scenario, Track track) {
  switch (track) {
    case Track::lattice: return gap(metrics, scenario.optimum);
    case Track::any_angle: return gap(metrics, scenario.any_angle_optimum);
    case Track::dynamic: return std::nullopt;
  }
  return std::nullopt;
}

std::optional<double> reference_length(const Scenario& scenario, Track track) {
  switch (track) {
    case Track::lattice:
      if (!scenario.optimum.length) return std::nullopt;
      return scenario.optimum.length->value();
    case Track::any_angle: return scenario.any_angle_optimum.length;
    case Track::dynamic: return std::nullopt;
  }
  return std::nullopt;
}

Proof proof_of(const Scenario& scenario, Track track) {
  if (!is_proven(scenario, track)) return Proof::none;
  return reference_length(scenario, track) ? Proof::way : Proof::no_way;
}

std::string contradiction(const PathMetrics& metrics, const Scenario& scenario, Track track) {
  const Proof proof = proof_of(scenario, track);
  if (proof == Proof::none) return "";
  if (proof == Proof::no_way) {
    return fmt::format("a legal path of {} where there is provably no way", metrics.length);
  }
  const std::optional<double> share = gap(metrics, scenario, track);
  if (!share || *share >= 0) return "";
  return fmt::format("a legal path of {} is shorter than the proven optimum {}", metrics.length,
                     *reference_length(scenario, track));
}

}  // namespace pathrace
