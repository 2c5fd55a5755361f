#include "algorithms/aco/held_path.hpp"

namespace pathrace::algorithms {

bool HeldPath::another_comes(std::size_t from, std::span<const std::uint8_t> directions, bool both_ways) {
  put_back();
  from_ = from;
  directions_.assign(directions.begin(), directions.end());
  both_ways_ = both_ways;
  known_ = true;
  return false;
}

void HeldPath::add(float added, float least, float most) {
  const Strengths lower = least - Strengths{};
  const Strengths upper = most - Strengths{};
  for (Block& block : blocks_) {
    const Strengths tau = block.strengths;
    const Strengths sum = (tau < lower ? lower : tau) + added;
    block.strengths = upper < sum ? upper : sum;
  }
}

void HeldPath::end() {
  put_back();
  known_ = false;
}

void HeldPath::drop() {
  held_ = known_ = false;
}

// False when the path comes to a row twice.
bool HeldPath::hold(TrailRow* rows, const RowSteps& steps) {
  float* const start = rows[from_].strength.data();
  const auto seen = [this, first = rows[0].strength.data()](const float* row) -> std::uint8_t& {
    return seen_[static_cast<std::size_t>(row - first) / floats_per_row];
  };
  const auto along = [&](const auto& take, const auto& visit) {
    const std::span<const std::uint8_t> directions = directions_;
    both_ways_ ? for_each_strength<true>(start, steps, directions, take, visit)
               : for_each_strength<false>(start, steps, directions, take, visit);
  };
  where_.clear();
  std::uint8_t twice = 0;
  along([&](float& tau) { where_.push_back(&tau); },
        [&](const float* row) {
          twice |= seen(row);
          seen(row) = 1;
        });
  along([](float&) {}, [&](const float* row) { seen(row) = 0; });
  if (twice != 0) return false;
  blocks_.resize((where_.size() + in_a_block - 1) / in_a_block);
  for (std::size_t k = 0; k < where_.size(); ++k) {
    blocks_[k / in_a_block].strengths[k % in_a_block] = *where_[k];
  }
  held_ = true;
  return true;
}

void HeldPath::put_back() {
  if (!held_) return;
  for (std::size_t k = 0; k < where_.size(); ++k) {
    *where_[k] = blocks_[k / in_a_block].strengths[k % in_a_block];
  }
  held_ = false;
}

}  // namespace pathrace::algorithms
