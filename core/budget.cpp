#include "core/budget.hpp"

#include <fmt/format.h>

namespace pathrace {

std::string to_string(const Budget& budget) {
  std::string text;
  const auto append = [&text](std::string_view name, const auto& limit) {
    if (limit) text += fmt::format("{}{}={}", text.empty() ? "" : ",", name, *limit);
  };
  append("evaluations", budget.evaluations);
  append("iterations", budget.iterations);
  append("checks", budget.checks);
  append("wall_s", budget.wall_s);
  return text.empty() ? "none" : text;
}

std::uint64_t work_hash(const Budget& budget) {
  Hasher hasher;
  for (const auto& limit : {budget.evaluations, budget.iterations, budget.checks}) {
    hasher.add(std::uint64_t{limit ? 1U : 0U}).add(limit.value_or(0));
  }
  return hasher.value();
}

}  // namespace pathrace
