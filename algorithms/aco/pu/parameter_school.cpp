#include "algorithms/aco/pu/parameter_school.hpp"

#include <algorithm>
#include <limits>

namespace pathrace::algorithms {
namespace {

Student origin(const Pu2022Settings& settings) {
  return {settings.alpha, settings.beta, settings.evaporation, settings.deposit};
}

// alpha, beta and evaporation as algorithms.md names them; the deposit within a factor of four.
Bounds bounds(const Pu2022Settings& settings) {
  return {{0.5, 1, 0.05, settings.deposit / 4}, {3, 9, 0.6, settings.deposit * 4}};
}

}  // namespace

ParameterSchool::ParameterSchool(const Pu2022Settings& settings, const Stream& stream)
    : stream_(stream),
      room_(static_cast<std::size_t>(settings.students), origin(settings), bounds(settings),
            settings.grouping, stream.fork("students")),
      chosen_(origin(settings)) {}

void ParameterSchool::begin(Colony& colony) {
  assign(colony);
}

void ParameterSchool::assign(Colony& colony) {
  tried_ = room_.candidates(stream_.fork("lessons").fork(lesson_++));
  std::vector<Taste> tastes;
  for (const Student& student : tried_) tastes.push_back({student[0], student[1]});
  colony.regroup(tastes);
}

void ParameterSchool::judge(const Colony& colony, const Harvest& harvest) {
  std::vector<double> fitness(tried_.size(), std::numeric_limits<double>::infinity());
  for (std::size_t k = 0; k < harvest.count; ++k) {
    const Walk& walk = colony.walks()[k];
    double& shortest = fitness[colony.group_of(k)];
    if (walk.arrived) shortest = std::min(shortest, walk.length.value());
  }
  const auto best =
      static_cast<std::size_t>(std::min_element(fitness.begin(), fitness.end()) - fitness.begin());
  if (fitness[best] < std::numeric_limits<double>::infinity()) chosen_ = tried_[best];
  room_.judge(tried_, fitness);
}

}  // namespace pathrace::algorithms
