// The trail's draft: what it will be after the iteration, made while ants still read what it is.
#include <numeric>

#include "algorithms/aco/trail.hpp"
#include "core/prefetch.hpp"

namespace pathrace::algorithms {

void Trail::keep_draft() {
  if (!stored_.empty()) return;
  draft_ = rows_;
  copies_ = rows_;
  copied_.resize(rows_.size());
  changed_ = RowMarks(rows_.size());
  listed_ = RowMarks(rows_.size());
  drafted_ = RowMarks(rows_.size());
  draft_is_close_ = true;
}

// The list is written anew only when it changes: all threads read it, and ants of a colony that has converged
// change the same rows each time.
void Trail::list_copied() {
  if (!draft_is_close_) {
    copied_count_ = copied_.size();
    std::iota(copied_.begin(), copied_.end(), 0U);
    listed_.add_all();
  } else if (listed_ != changed_) {
    copied_count_ = static_cast<std::size_t>(changed_.list(copied_.data()) - copied_.data());
    listed_ = changed_;
  }
}

void Trail::write_copies() {
  list_copied();
  for (const std::uint32_t index : copied()) copies_[index].strength = rows_[index].strength;
}

void Trail::fill_draft() {
  for (const std::uint32_t index : copied()) draft_[index].strength = rows_[index].strength;
  drafted_.clear();
  held_.drop();
  draft_is_due_ = false;
}

bool Trail::begin_draft(double persistence) {
  draft_scale_ = scale_ * persistence;
  drafting_ = !draft_.empty() && draft_scale_ >= smallest_scale_;
  if (!drafting_) return false;
  draft_bounds_ = bounds_at(draft_scale_);
  write_copies();
  draft_is_due_ = true;
  draft_is_close_ = false;  // unless it is adopted
  return true;
}

// The rows of a held path have been marked when it came first.
void Trail::deposit_on_draft(std::size_t index, std::span<const std::uint8_t> directions, double amount,
                             bool both_ways) {
  if (draft_is_due_) fill_draft();
  const auto added = static_cast<float>(amount / draft_scale_);
  const auto [least, most] = draft_bounds_;
  if (held_.comes(draft_.data(), steps_, index, directions, both_ways)) return held_.add(added, least, most);
  visit_draft(index, directions, both_ways, addition(added, least, most));
}

void Trail::change_draft_along(std::size_t index, std::span<const std::uint8_t> directions, double factor,
                               double amount, bool both_ways) {
  if (draft_is_due_) fill_draft();
  held_.end();
  const auto added = static_cast<float>(amount / draft_scale_);
  const auto [least, most] = draft_bounds_;
  visit_draft(index, directions, both_ways, alteration(static_cast<float>(factor), added, least, most));
}

template <typename Change>
void Trail::visit_draft(std::size_t index, std::span<const std::uint8_t> directions, bool both_ways,
                        const Change& change) {
  float* const row = draft_[index].strength.data();
  const auto mark = [add_row = drafted_.adder(), first = draft_[0].strength.data()](const float* visited) {
    add_row(static_cast<std::size_t>(visited - first) / floats_per_row);
  };
  both_ways ? for_each_strength<true>(row, steps_, directions, change, mark)
            : for_each_strength<false>(row, steps_, directions, change, mark);
}

void Trail::adopt_draft() {
  if (draft_is_due_) fill_draft();
  held_.end();
  rows_.swap(draft_);
  changed_.swap(drafted_);
  draft_is_close_ = true;
  drafting_ = false;
  scale_ = draft_scale_;
  rescale();
}

void Trail::fetch_copies() const {
  for (const std::uint32_t index : copied()) prefetch(&copies_[index]);
}

void Trail::claim_copies() const {
  for (const std::uint32_t index : copied()) prefetch_to_write(&copies_[index]);
}

}  // namespace pathrace::algorithms
