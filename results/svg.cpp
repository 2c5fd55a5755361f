#include "results/svg.hpp"

#include "results/picture.hpp"
#include "results/svg_pen.hpp"

namespace pathrace::results {

void write_svg(std::ostream& out, const Scenario& scenario, const Answer& answer, const std::string& title,
               const Overlay& overlay) {
  const PictureLayout layout = layout_of(scenario.grid());
  SvgPen pen(out, layout.width, layout.height, title);
  draw_picture(pen, layout, scenario, answer, overlay, title);
  pen.finish();
}

}  // namespace pathrace::results
