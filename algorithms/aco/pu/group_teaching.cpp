#include "algorithms/aco/pu/group_teaching.hpp"

#include <algorithm>
#include <cassert>
#include <limits>
#include <numeric>

namespace pathrace::algorithms {
namespace {

constexpr std::size_t best_three = 3;

template <typename Combine>
Student each(const Combine& combine) {
  Student result{};
  for (std::size_t k = 0; k < result.size(); ++k) result[k] = combine(k);
  return result;
}

}  // namespace

Classroom::Classroom(std::size_t count, const Student& origin, const Bounds& bounds, bool grouping,
                     Stream stream)
    : bounds_(bounds), grouping_(grouping), fitness_(count, std::numeric_limits<double>::infinity()) {
  assert(count >= best_three);
  for (std::size_t i = 0; i < count; ++i) {
    students_.push_back(i == 0 ? bounded(origin) : each([&](std::size_t k) {
      return bounds.low[k] + stream.uniform() * (bounds.high[k] - bounds.low[k]);
    }));
  }
  before_ = students_;
  teacher_ = students_.front();
}

std::vector<std::size_t> Classroom::ranking() const {
  std::vector<std::size_t> order(students_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t j) { return fitness_[i] < fitness_[j]; });
  return order;
}

Student Classroom::mean_of_best(std::size_t count) const {
  const std::vector<std::size_t> order = ranking();
  return each([&](std::size_t k) {
    double sum = 0;
    for (std::size_t i = 0; i < count; ++i) sum += students_[order[i]][k];
    return sum / static_cast<double>(count);
  });
}

Student Classroom::bounded(Student student) const {
  return each([&](std::size_t k) { return std::clamp(student[k], bounds_.low[k], bounds_.high[k]); });
}

Student Classroom::outstanding(std::size_t i, const Student& group_mean, Stream stream) const {
  const double a = stream.uniform();
  const double b = stream.uniform();
  const double factor = stream.chance(0.5) ? 2 : 1;
  const Student& x = students_[i];
  return each([&](std::size_t k) {
    return x[k] + a * (teacher_[k] - factor * (b * group_mean[k] + (1 - b) * x[k]));
  });
}

Student Classroom::average(std::size_t i, Stream stream) const {
  const double d = stream.uniform();
  const Student& x = students_[i];
  return each([&](std::size_t k) { return x[k] + 2 * d * (teacher_[k] - x[k]); });
}

Student Classroom::peer_taught(std::size_t i, Stream stream) const {
  std::size_t peer = stream.below(students_.size() - 1);
  peer += peer >= i ? 1 : 0;
  const double e = stream.uniform();
  const double g = stream.uniform();
  const double sign = fitness_[i] < fitness_[peer] ? 1 : -1;
  const Student& x = students_[i];
  return each([&](std::size_t k) {
    return x[k] + sign * e * (x[k] - students_[peer][k]) + g * (x[k] - before_[i][k]);
  });
}

std::vector<Student> Classroom::candidates(const Stream& stream) const {
  std::vector<Student> tried = students_;
  if (phase_ == Phase::teacher) {
    const std::vector<std::size_t> order = ranking();
    const std::size_t better = grouping_ ? (students_.size() + 1) / 2 : 0;
    const Student group_mean = mean_of_best(std::max<std::size_t>(better, 1));
    for (std::size_t rank = 0; rank < order.size(); ++rank) {
      const std::size_t i = order[rank];
      tried[i] = rank < better ? outstanding(i, group_mean, stream.fork(i)) : average(i, stream.fork(i));
    }
  } else if (phase_ == Phase::student) {
    for (std::size_t i = 0; i < students_.size(); ++i) tried[i] = peer_taught(i, stream.fork(i));
  }
  for (Student& student : tried) student = bounded(student);
  tried.push_back(mean_of_best(best_three));
  return tried;
}

void Classroom::judge(const std::vector<Student>& tried, const std::vector<double>& fitness) {
  assert(tried.size() == students_.size() + 1 && fitness.size() == tried.size());
  if (phase_ != Phase::student) before_ = students_;
  for (std::size_t i = 0; i < students_.size(); ++i) {
    if (phase_ != Phase::first && !(fitness[i] < fitness_[i])) continue;
    students_[i] = tried[i];
    fitness_[i] = fitness[i];
  }
  const std::size_t best = ranking().front();
  teacher_ = fitness_[best] <= fitness.back() ? students_[best] : tried.back();
  phase_ = phase_ == Phase::teacher ? Phase::student : Phase::teacher;
}

}  // namespace pathrace::algorithms
