#include "core/record.hpp"

#include <algorithm>

#include "core/hash.hpp"

namespace pathrace {
namespace {

void add_work(Hasher& hasher, const Work& work) {
  hasher.add(work.evaluations).add(work.iterations).add(work.checks);
}

}  // namespace

std::uint64_t TrialKey::hash() const {
  return Hasher()
      .add(std::string_view(scenario))
      .add(content)
      .add(std::string_view(planner))
      .add(version)
      .add(repetition)
      .add(seed)
      .add(budget)
      .value();
}

Stream root_stream(std::uint64_t seed, std::string_view scenario, std::uint64_t repetition) {
  return Stream(seed).fork(scenario).fork(repetition);
}

std::uint64_t digest(const TrialRecord& record) {
  Hasher hasher;
  hasher.add(name(record.verdict));
  hasher.add(std::uint64_t{record.answer ? 1U : 0U});
  if (record.answer) {
    hasher.add(name(record.answer->track)).add(std::uint64_t{record.answer->points.size()});
    for (const Point point : record.answer->points) hasher.add(point.x).add(point.y);
  }
  add_work(hasher, record.work);
  hasher.add(std::uint64_t{record.trace.size()});
  for (const TracePoint& point : record.trace) {
    add_work(hasher, point.work);
    hasher.add(point.cost);
  }
  return hasher.value();
}

std::uint64_t campaign_digest(std::vector<KeyedDigest> rows) {
  std::sort(rows.begin(), rows.end(), [](const KeyedDigest& a, const KeyedDigest& b) {
    return std::pair(a.key, a.digest) < std::pair(b.key, b.digest);
  });
  Hasher hasher;
  for (const KeyedDigest& row : rows) {
    if (!row.timed) hasher.add(row.key).add(row.digest);
  }
  return hasher.value();
}

}  // namespace pathrace
