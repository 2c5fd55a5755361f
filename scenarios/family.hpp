// A scenario family: a seeded generator whose ids name the question for ever.
//
// Same id, same bits, on any machine: a family draws only from the stream of its id, and what it builds is
// certified by exact search before anybody sees it. Most families are made by generated_family
// (scenarios/generated.hpp) from a drawing function and a schema of parameters.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/parameters.hpp"
#include "core/scenario.hpp"
#include "core/stream.hpp"

namespace pathrace::scenarios {

/// What a generator draws; the move rule is always `strict`.
struct Sketch {
  OccupancyGrid grid;
  Cell start;
  Cell goal;
};

struct Family {
  std::string name;                       ///< first part of the id
  std::string form;                       ///< "dense/<n>-<percent>/<seed>"
  std::string summary;                    ///< one line
  std::vector<std::string> library;       ///< the ids that the library lists
  std::vector<ParameterCard> parameters;  ///< what an id may say beside size and seed
  /// The scenario with this id, certified: valid, solvable, with its proven optimum. `parts` are the id's
  /// parts after the name. Throws InputError for parts that do not fit the form.
  std::function<Scenario(const std::string& id, const std::vector<std::string_view>& parts)> make;
  bool dynamic = false;  ///< worlds of moving discs: no move rule, no optimum
};

/// All families, sorted by name.
const std::vector<Family>& families();

/// Draws sketches from fork 0, 1, 2, ... of the id's stream until exact search finds a way between two
/// different ends (certified rejection); a drawing may also give up on its fork. Throws InvalidScenario when
/// none of `attempts` is solvable.
Scenario certified(const std::string& id, const std::function<std::optional<Sketch>(Stream)>& draw,
                   int attempts = 1000);

/// One number of an id. Throws InputError naming the id, the part, and low..high.
int id_number(std::string_view id, std::string_view what, std::string_view text, int low, int high);
/// Throws InputError that shows the form unless there are `count` parts.
void require_parts(std::string_view id, std::string_view form, const std::vector<std::string_view>& parts,
                   std::size_t count);

/// Ids `prefix/1` to `prefix/30` for each prefix, without repeats (scenarios/repeats.hpp): the library's
/// seeds.
std::vector<std::string> thirty_seeds(const std::vector<std::string>& prefixes);

inline constexpr int least_side = 5;
inline constexpr int most_side = 4096;
inline constexpr int most_seed = 2'000'000'000;

}  // namespace pathrace::scenarios
