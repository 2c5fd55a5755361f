// Figures on the terminal, a dash where there is none.
#pragma once

#include <fmt/format.h>

#include <optional>
#include <string>
#include <string_view>

namespace pathrace::bench::cli {

inline std::string or_dash(const std::optional<double>& value, std::string_view format) {
  return value ? fmt::format(fmt::runtime(format), *value) : "-";
}

inline std::string percent_or_dash(const std::optional<double>& share) {
  return share ? fmt::format("{:.2f} %", 100 * *share) : "-";
}

}  // namespace pathrace::bench::cli
