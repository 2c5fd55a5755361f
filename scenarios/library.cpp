#include "scenarios/library.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <iterator>
#include <set>
#include <utility>

#include "core/error.hpp"
#include "core/names.hpp"
#include "core/reference/exact_search.hpp"
#include "scenarios/family.hpp"
#include "scenarios/glob.hpp"
#include "scenarios/recorded.hpp"
#include "scenarios/ros/ros_queries.hpp"
#include "scenarios/sets.hpp"
#include "scenarios/text.hpp"
#include "scenarios/under_rule.hpp"

namespace pathrace::scenarios {
namespace {

constexpr std::string_view recorded_family = "movingai";
constexpr std::string_view ros_family = "ros";
constexpr std::size_t longest_pattern = 1000;  // bytes
constexpr std::int64_t most_ids = 1'000'000;   // that the ranges of one pattern stand for
constexpr std::size_t most_globs = 10'000;     // the same beside * ? [, each of which searches the list

std::string unknown_family(std::string_view name, std::string_view id) {
  std::vector<std::string> known{std::string(recorded_family), std::string(ros_family)};
  for (const Family& family : families()) known.push_back(family.name);
  return fmt::format("scenario '{}': {}", id, unknown_name("family", name, known));
}

// "dense/20-20/1..30" stands for thirty ids; a pattern without a range for itself.
std::vector<std::string> expand_range(const std::string& pattern) {
  const std::size_t dots = pattern.find("..");
  if (dots == std::string::npos) return {pattern};
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  std::size_t begin = dots;
  while (begin > 0 && is_digit(pattern[begin - 1])) --begin;
  std::size_t end = dots + 2;
  while (end < pattern.size() && is_digit(pattern[end])) ++end;
  int first = 0;
  int last = 0;
  const bool readable =
      std::from_chars(pattern.data() + begin, pattern.data() + dots, first).ec == std::errc{} &&
      std::from_chars(pattern.data() + dots + 2, pattern.data() + end, last).ec == std::errc{};
  const std::vector<std::string> rests = expand_range(pattern.substr(end));
  const std::int64_t seeds = std::int64_t{last} - first + 1;
  if (!readable || seeds < 1 || seeds * static_cast<std::int64_t>(rests.size()) > most_ids) {
    throw InputError(fmt::format(
        "scenario pattern '{}': expected a range FIRST..LAST of at most a million seeds, such as 1..30",
        pattern));
  }
  std::vector<std::string> ids;
  for (int seed = first;; ++seed) {
    for (const std::string& rest : rests)
      ids.push_back(fmt::format("{}{}{}", pattern.substr(0, begin), seed, rest));
    if (seed == last) return ids;
  }
}

bool is_number(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

// "dense/20-20/7" -> "dense/20-20" and "7".
std::pair<std::string, std::string> split_seed(const std::string& id) {
  const std::size_t slash = id.rfind('/');
  if (slash == std::string::npos) return {id, ""};
  return {id.substr(0, slash), id.substr(slash + 1)};
}

// What the listed ids of generated families are with this seed. The list holds the seeds of one family and
// size one after another.
std::vector<std::string> with_seed(const std::vector<std::string>& listed, const std::string& glob,
                                   const std::string& seed) {
  std::vector<std::string> ids;
  for (const std::string& id : listed) {
    const auto [size, listed_seed] = split_seed(id);
    if (!is_number(listed_seed) || !glob_matches(glob, size)) continue;
    std::string seeded = fmt::format("{}/{}", size, seed);
    if (ids.empty() || ids.back() != seeded) ids.push_back(std::move(seeded));
  }
  return ids;
}

// The ids that a pattern with * ? [ stands for; of generated families also those with a seed that is not
// listed.
std::vector<std::string> matching(const std::string& glob, const std::vector<std::string>& listed) {
  const bool is_generated = !glob.starts_with(recorded_family) && !glob.starts_with(ros_family);
  if (const auto [size, seed] = split_seed(glob); is_generated && is_number(seed)) {
    return with_seed(listed, size, seed);
  }
  std::vector<std::string> ids;
  std::copy_if(listed.begin(), listed.end(), std::back_inserter(ids),
               [&](const std::string& id) { return glob_matches(glob, id); });
  return ids;
}

}  // namespace

class Library::Recorded : public RecordedQueries {
 public:
  using RecordedQueries::RecordedQueries;
};

Library::Library(std::optional<std::filesystem::path> maps) : maps_(std::move(maps)) {
  if (!maps_) return;
  ros_ = std::make_unique<RosQueries>(*maps_);
  recorded_ = std::make_unique<Recorded>(*maps_);
}

Library::~Library() = default;

Library::Recorded& Library::recorded(const std::string& id) const {
  if (!recorded_) {
    throw InputError(
        fmt::format("scenario '{}' needs a folder of .map and .scen files: name one with --maps", id));
  }
  return *recorded_;
}

RosQueries& Library::ros(const std::string& id) const {
  if (!ros_) {
    throw InputError(fmt::format("scenario '{}' needs a folder of ROS maps: name one with --maps", id));
  }
  return *ros_;
}

std::vector<std::string> Library::listed_for(const std::string& pattern) const {
  const std::string_view family = split_at(pattern, '/')[0];
  if (family == ros_family) return ros(pattern).list();
  return pattern.starts_with(recorded_family) ? recorded(pattern).list() : list();
}

std::vector<std::string> Library::list() const {
  std::vector<std::string> ids;
  for (const Family& family : families()) ids.insert(ids.end(), family.library.begin(), family.library.end());
  return ids;
}

Scenario Library::load(const std::string& full_id) const {
  const auto [id, rule] = split_rule(full_id);
  Scenario scenario = load_plain(id);
  return rule ? under_rule(std::move(scenario), *rule) : scenario;
}

Scenario Library::load_plain(const std::string& id) const {
  const std::vector<std::string_view> parts = split_at(id, '/');
  if (parts[0] == recorded_family) {
    require_parts(id, "movingai/<scen>/<k>", {parts.begin() + 1, parts.end()}, 2);
    return recorded(id).load(id, std::string(parts[1]), std::string(parts[2]));
  }
  if (parts[0] == ros_family) {
    require_parts(id, "ros/<map>/<k>", {parts.begin() + 1, parts.end()}, 2);
    return ros(id).load(id, std::string(parts[1]), std::string(parts[2]));
  }
  for (const Family& family : families()) {
    if (family.name == parts[0]) return family.make(id, {parts.begin() + 1, parts.end()});
  }
  throw InputError(unknown_family(parts[0], id));
}

std::vector<std::string> Library::select(const std::string& pattern) const {
  if (pattern.starts_with(set_prefix)) {
    return ids_of(find_set(std::string_view(pattern).substr(set_prefix.size())), *this);
  }
  if (pattern.size() > longest_pattern) {
    throw InputError(fmt::format("scenario pattern '{}' has {} bytes; expected at most {}",
                                 printable(pattern), pattern.size(), longest_pattern));
  }
  std::vector<std::string> items = expand_range(pattern);
  if (pattern.find_first_of("*?[") == std::string::npos) return items;
  if (items.size() > most_globs) {
    throw InputError(fmt::format("scenario pattern '{}' stands for {} patterns; expected at most {}", pattern,
                                 items.size(), most_globs));
  }
  const std::vector<std::string> listed = listed_for(pattern);
  std::vector<std::string> ids;
  for (const std::string& item : items) {
    const std::vector<std::string> found = matching(item, listed);
    if (found.empty())
      throw InputError(fmt::format("scenario pattern '{}' matches nothing in the library", item));
    ids.insert(ids.end(), found.begin(), found.end());
  }
  return ids;
}

Offer Library::offer(const OfferLimits& limits) const {
  Offer offer;
  recorded("movingai/*/*").offer(limits, offer);
  ros("ros/*/*").offer(limits, offer);
  const std::set<std::filesystem::path> maps = recorded_->maps();
  offer_map_files(*maps_, {maps.begin(), maps.end()}, limits, offer);
  return offer;
}

void prove(Scenario& scenario) {
  if (!scenario.optimum.proven && !scenario.world) {
    scenario.optimum = reference::optimum(scenario.terrain, scenario.start, scenario.goal);
  }
}

}  // namespace pathrace::scenarios
