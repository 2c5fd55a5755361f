// A colony whose groups of ants learn their own parameters.
//
// Each group is a student of group_teaching: it walks with its own alpha and beta on the colony's one trail,
// and its fitness is the length of the best path of its ants in this iteration. The trail is evaporated and
// paid by the rate and the deposit of the group that was best.
//
// Mapping A of the reconstruction of grouped teaching, algorithms.md 3.5.
#pragma once

#include <vector>

#include "algorithms/aco/colony.hpp"
#include "algorithms/aco/pu/group_teaching.hpp"
#include "algorithms/aco/pu/pu2022.hpp"

namespace pathrace::algorithms {

class ParameterSchool {
 public:
  ParameterSchool(const Pu2022Settings& settings, const Stream& stream);

  /// Divides the ants into groups.
  void begin(Colony& colony);
  /// What the groups have brought home.
  void judge(const Colony& colony, const Harvest& harvest);
  /// The next candidates, on the trail as it is now.
  void assign(Colony& colony);

  double evaporation() const { return chosen_[2]; }
  double deposit() const { return chosen_[3]; }

 private:
  Stream stream_;
  Classroom room_;
  std::vector<Student> tried_;
  Student chosen_;  // the best group's of the last iteration
  std::uint64_t lesson_ = 0;
};

}  // namespace pathrace::algorithms
