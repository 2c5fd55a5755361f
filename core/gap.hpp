// Gaps: by what share a path is longer than the proven shortest one of its track.
//
// On the lattice, lengths are counts of steps and compare exactly. An any-angle length is a sum of rounded
// roots: n of them are off by at most (n + 2) 2^-53 of their sum, and a path that the referee lets graze a
// corner by rounding is shorter by as little. So any-angle lengths within one part in 10^12 of the reference,
// the bound for some 4000 points on either side, count as equal to it.
#pragma once

#include <optional>
#include <string>

#include "core/metrics.hpp"
#include "core/path.hpp"
#include "core/scenario.hpp"

namespace pathrace {

inline constexpr double any_angle_rounding = 1e-12;  ///< share of the reference within which lengths agree

/// length / optimum - 1 of a lattice path: exactly 0 at the optimum; nothing where there is no reference.
std::optional<double> gap(const PathMetrics& metrics, const Optimum& optimum);
/// The same of an any-angle path: exactly 0 within rounding of the optimum.
std::optional<double> gap(const PathMetrics& metrics, const AnyAngleOptimum& optimum);
/// The same on the track that the path raced on; nothing on `dynamic`.
std::optional<double> gap(const PathMetrics& metrics, const Scenario& scenario, Track track);

/// What a gap on this track counts from, in cell edges; nothing where none is proven or there is no way, and
/// on `dynamic`, where runs count steps.
std::optional<double> reference_length(const Scenario& scenario, Track track);

/// What exact search knows about a way on this track.
enum class Proof { none, way, no_way };
Proof proof_of(const Scenario& scenario, Track track);

/// What a legal path says against the proof: it is shorter than the proven optimum, or there should be no
/// way. Then reference, referee or move rule are wrong. Empty where nothing is, or nothing is proven.
std::string contradiction(const PathMetrics& metrics, const Scenario& scenario, Track track);

}  // namespace pathrace
