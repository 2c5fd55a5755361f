// How a planner's overlay looks: a field as shades of one colour, circles and a line.
#pragma once

#include <vector>

#include "core/overlay.hpp"
#include "results/picture_style.hpp"

namespace pathrace::results {

inline constexpr int most_shade = 24;
inline constexpr double strongest_shade = 0.9;              ///< opacity
inline constexpr Colour shade_colour = {0xff, 0xc0, 0x2e};  // amber, beside the orange of paths
inline constexpr double overlay_line = 1.5;                 ///< width of circles and line, pixels
inline constexpr double overlay_dash = 4;                   ///< of the line, in its widths

/// 0..most_shade for each value of a field: the square root of its place between the least positive value and
/// the greatest, so that weak trails show. 0 for values that are not positive, and all 0 for an even field.
std::vector<int> shades_of(const std::vector<double>& field);

}  // namespace pathrace::results
