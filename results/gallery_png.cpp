#include "results/canvas_pen.hpp"
#include "results/gallery.hpp"
#include "results/png.hpp"

namespace pathrace::results {

void write_gallery_png(std::ostream& out, const std::vector<Tile>& tiles) {
  const Sheet sheet = sheet_of(tiles);
  Canvas canvas(static_cast<int>(sheet.width), static_cast<int>(sheet.height), palette.paper);
  CanvasPen pen(canvas);
  draw_gallery(pen, sheet, tiles);
  out << png_bytes(canvas);
}

}  // namespace pathrace::results
