#include "results/references.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "results/binder.hpp"
#include "results/columns.hpp"
#include "results/number_text.hpp"
#include "results/quote.hpp"

namespace pathrace::results {
namespace {

std::string text(const std::optional<double>& length) {
  return length ? print_number(*length) : "none";
}

}  // namespace

References::References(SQLite::Database& database)
    : find_(database, "SELECT length FROM reference WHERE scenario = ? AND track = ?"),
      insert_(database, "INSERT INTO reference (scenario, track, length) VALUES (?, ?, ?)") {}

void References::put(std::int64_t scenario, const std::string& id, Track track,
                     std::optional<double> length) {
  if (track == Track::dynamic) return;  // runs count steps
  auto known = known_.find({scenario, track});
  if (known == known_.end()) {
    known = known_.emplace(std::pair(scenario, track), stored(scenario, track, length)).first;
  }
  if (known->second == length) return;
  throw InputError(
      fmt::format("the store has {} for the optimum of {} on the track {}, this program finds {}",
                  text(known->second), results::quoted(id), name(track), text(length)));
}

// What is stored after the call: what was there, or else `length`.
std::optional<double> References::stored(std::int64_t scenario, Track track, std::optional<double> length) {
  Binder(find_).integer(scenario).name(name(track));
  if (find_.executeStep()) {
    length = Columns(find_).optional_real();
  } else {
    Binder(insert_).integer(scenario).name(name(track)).real(length);
    insert_.exec();
  }
  find_.reset();
  return length;
}

}  // namespace pathrace::results
