// The 5 x 5 maps of the AS-R robot, from the text of the genetic algorithm's paper (algorithms.md 5, 6).
//
// Cells are 50 cm there; here, as everywhere, the unit is one cell. Start is the upper left corner, goal the
// lower right. Optima under `strict`: fig2 6.8284, fig5 6.2426, fig6 6.8284.
#include <fmt/format.h>

#include <array>

#include "core/error.hpp"
#include "core/names.hpp"
#include "scenarios/family.hpp"

namespace pathrace::scenarios {
namespace {

struct Figure {
  std::string_view name;
  std::array<int, 4> blocked;  // index 5 * row + column; -1 is none
};

constexpr std::array<Figure, 3> figures = {{
    {"fig2", {4, 7, 17, 20}},
    {"fig5", {8, 11, -1, -1}},
    {"fig6", {7, 17, -1, -1}},
}};

Scenario make(const std::string& id, const std::vector<std::string_view>& parts) {
  require_parts(id, "asr/fig2|fig5|fig6", parts, 1);
  std::vector<std::string> known;
  for (const Figure& figure : figures) {
    known.emplace_back(figure.name);
    if (figure.name != parts[0]) continue;
    return certified(id, [&figure](Stream) {
      Sketch sketch{OccupancyGrid(5, 5), {0, 0}, {4, 4}};
      for (const int index : figure.blocked) {
        if (index >= 0) sketch.grid.block({index % 5, index / 5});
      }
      return sketch;
    });
  }
  throw InputError(fmt::format("scenario '{}': {}", id, unknown_name("figure", parts[0], known)));
}

}  // namespace

Family asr_family() {
  return {"asr",
          "asr/fig2|fig5|fig6",
          "the 5 x 5 maps of the AS-R robot",
          {"asr/fig2", "asr/fig5", "asr/fig6"},
          {},
          make};
}

}  // namespace pathrace::scenarios
