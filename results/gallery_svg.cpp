#include "results/gallery.hpp"
#include "results/svg_pen.hpp"

namespace pathrace::results {

void write_gallery_svg(std::ostream& out, const std::vector<Tile>& tiles) {
  const Sheet sheet = sheet_of(tiles);
  SvgPen pen(out, sheet.width, sheet.height, "pathrace scenarios");
  draw_gallery(pen, sheet, tiles);
  pen.finish();
}

}  // namespace pathrace::results
