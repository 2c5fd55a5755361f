#include "bench/features/feature.hpp"

namespace pathrace::bench {
namespace {

// A check of A* is a cell expanded; where there is no way, it expands all that can be reached.
std::optional<double> expansions(FeatureContext& context) {
  return static_cast<double>(context.astar().work.checks);
}

}  // namespace

Feature expansions_feature() {
  return {"expansions", "cells", "cells that A* expands", FeatureType::integer, expansions};
}

}  // namespace pathrace::bench
