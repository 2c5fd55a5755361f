#include "results/picture_style.hpp"

#include <fmt/format.h>

namespace pathrace::results {

std::string css(Colour colour) {
  return fmt::format("#{:02x}{:02x}{:02x}", colour.red, colour.green, colour.blue);
}

Palette<std::string> css(const Palette<Colour>& colours) {
  return {css(colours.paper),    css(colours.ground), css(colours.grid),
          css(colours.obstacle), css(colours.path),   css(colours.start),
          css(colours.goal),     css(colours.ink),    css(colours.faint)};
}

}  // namespace pathrace::results
