// How pictures look: colours and widths that SVG, PNG and the gallery share.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>

namespace pathrace::results {

struct Colour {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;

  friend bool operator==(const Colour&, const Colour&) = default;
};

/// "#e8590c"
std::string css(Colour colour);

/// What is painted with what: colours, or their names in a style sheet.
template <typename Paint>
struct Palette {
  Paint paper;
  Paint ground;
  Paint grid;
  Paint obstacle;
  Paint path;
  Paint start;
  Paint goal;
  Paint ink;
  Paint faint;
};

inline constexpr Palette<Colour> palette = {
    .paper = {0xff, 0xff, 0xff},
    .ground = {0xfb, 0xfa, 0xf6},
    .grid = {0xe4, 0xe0, 0xd6},
    .obstacle = {0x3b, 0x44, 0x52},
    .path = {0xe8, 0x59, 0x0c},  // orange and teal differ for every kind of colour vision
    .start = {0x0b, 0x72, 0x85},
    .goal = {0xc2, 0x25, 0x5c},
    .ink = {0x21, 0x25, 0x29},
    .faint = {0x6b, 0x72, 0x80},
};

Palette<std::string> css(const Palette<Colour>& colours);

inline constexpr int finest_grid = 64;    ///< grid lines on maps up to so many cells a side
inline constexpr double frame_width = 2;  ///< of the line around a map, in pixels

// Widths in cells. What must stay visible on large maps is bounded in pixels; a cell has `scale` of them.
inline double path_width(double scale) {
  return std::max(0.17, 2.5 / scale);
}
inline double halo_width(double scale) {
  return path_width(scale) + std::max(0.08, 2 / scale);
}
inline double mark_radius(double scale) {
  return std::max(0.34, 7 / scale);
}

/// Parts of the two marks, in radii of a mark. The goal's ring leaves room for the start's disc: both show
/// when start and goal are one cell.
namespace mark {
inline constexpr double start_disc = 0.7;
inline constexpr double start_edge = 0.22;  ///< width
inline constexpr double goal_halo = 0.62;   ///< width
inline constexpr double goal_ring = 0.3;    ///< width
inline constexpr double goal_heart = 0.38;
}  // namespace mark

}  // namespace pathrace::results
