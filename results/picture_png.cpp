#include "results/picture_png.hpp"

#include "results/canvas_pen.hpp"
#include "results/picture.hpp"
#include "results/png.hpp"

namespace pathrace::results {

void write_png(std::ostream& out, const Scenario& scenario, const Shown& shown) {
  const PictureLayout layout = layout_of(scenario.grid());
  Canvas canvas(static_cast<int>(layout.width), static_cast<int>(layout.height), palette.paper);
  CanvasPen pen(canvas);
  draw_picture(pen, layout, scenario, shown);
  out << png_bytes(canvas);
}

}  // namespace pathrace::results
