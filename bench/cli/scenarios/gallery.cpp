// `scenarios gallery`: every family at a glance.
#include <filesystem>
#include <memory>
#include <sstream>

#include "bench/cli/picture_file.hpp"
#include "bench/cli/scenarios/verb.hpp"
#include "bench/gallery_tiles.hpp"
#include "bench/run_folder.hpp"
#include "results/gallery_html.hpp"

namespace pathrace::bench::cli {
namespace {

int draw_gallery(const std::string& file) {
  require_extension(file, {".html", ".png", ".svg"});
  const std::string extension = std::filesystem::path(file).extension().string();
  std::ostringstream bytes;
  if (extension == ".html") {
    results::write_gallery_html(bytes, gallery_tiles(3));
  } else if (extension == ".png") {
    results::write_gallery_png(bytes, gallery_tiles(1));
  } else {
    results::write_gallery_svg(bytes, gallery_tiles(1));
  }
  write_file(file, bytes.str());
  return done;
}

}  // namespace

void add_scenarios_gallery(CLI::App& parent) {
  auto file = std::make_shared<std::string>();
  CLI::App* verb = add_verb(parent, "gallery", "every family at a glance, each with a shortest path",
                            "-o gallery.html", [file] { return draw_gallery(*file); });
  verb->add_option("-o,--out", *file, "a .html, .png or .svg file")->required()->type_name("FILE");
}

}  // namespace pathrace::bench::cli
