// The median of a sample.
#pragma once

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace pathrace::results {

/// Middle value; mean of the two middle values when the count is even. Infinite values are welcome, NaN is
/// not. Throws std::invalid_argument on an empty sample: "no data" is not zero.
inline double median(std::vector<double> sample) {
  if (sample.empty()) throw std::invalid_argument("median of an empty sample");
  const auto middle = sample.begin() + static_cast<std::ptrdiff_t>(sample.size() / 2);
  std::nth_element(sample.begin(), middle, sample.end());
  if (sample.size() % 2 == 1) return *middle;
  return std::midpoint(*std::max_element(sample.begin(), middle), *middle);
}

}  // namespace pathrace::results
