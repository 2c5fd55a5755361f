#include "results/svg.hpp"

#include "results/picture.hpp"
#include "results/svg_pen.hpp"

namespace pathrace::results {

void write_svg(std::ostream& out, const Scenario& scenario, const Shown& shown) {
  const PictureLayout layout = layout_of(scenario.grid());
  SvgPen pen(out, layout.width, layout.height, shown.title);
  draw_picture(pen, layout, scenario, shown);
  pen.finish();
}

}  // namespace pathrace::results
