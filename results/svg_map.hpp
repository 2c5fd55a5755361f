// The parts of a picture as SVG elements, in the units of the group or view box around them.
#pragma once

#include <ostream>

#include "core/overlay.hpp"
#include "core/planner.hpp"
#include "core/scenario.hpp"
#include "results/picture_style.hpp"

namespace pathrace::results {

/// Ground, overlay, grid lines, obstacles, frame, path, goal and start, in cell units: cell (0, 0) covers
/// -0.5..0.5. A cell is drawn with about `scale` pixels. The paints are written as they are: colours or
/// var(--name).
void write_svg_map(std::ostream& out, const Scenario& scenario, const Answer& answer, const Overlay& overlay,
                   double scale, const Palette<std::string>& paints);

void write_svg_start(std::ostream& out, double x, double y, double radius,
                     const Palette<std::string>& paints);
void write_svg_goal(std::ostream& out, double x, double y, double radius, const Palette<std::string>& paints);

}  // namespace pathrace::results
