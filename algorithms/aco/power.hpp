// Powers whose bits do not depend on the C library where they need not: integer exponents are multiplied out.
#pragma once

#include <cmath>

namespace pathrace::algorithms {

inline double power(double base, double exponent) {
  if (exponent < 0 || exponent > 64 || exponent != std::floor(exponent)) return std::pow(base, exponent);
  double result = 1;
  for (auto bits = static_cast<unsigned>(exponent); bits != 0; bits >>= 1U, base *= base) {
    if ((bits & 1U) != 0) result *= base;
  }
  return result;
}

}  // namespace pathrace::algorithms
