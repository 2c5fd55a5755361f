#include "results/overlay_style.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pathrace::results {

std::vector<int> shades_of(const std::vector<double>& field) {
  double least = std::numeric_limits<double>::infinity();
  double greatest = 0;
  for (const double value : field) {
    if (!(value > 0) || !std::isfinite(value)) continue;
    least = std::min(least, value);
    greatest = std::max(greatest, value);
  }
  std::vector<int> shades(field.size(), 0);
  if (!(least < greatest)) return shades;
  for (std::size_t i = 0; i < field.size(); ++i) {
    const double place = std::clamp((field[i] - least) / (greatest - least), 0.0, 1.0);
    if (field[i] > 0) shades[i] = static_cast<int>(std::sqrt(place) * most_shade + 0.5);
  }
  return shades;
}

}  // namespace pathrace::results
