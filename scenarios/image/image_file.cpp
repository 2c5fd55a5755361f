#include "scenarios/image/image_file.hpp"

#include <fmt/format.h>

#include "core/grid.hpp"
#include "scenarios/file_bytes.hpp"
#include "scenarios/text.hpp"

namespace pathrace::scenarios {
namespace {

// 16-bit colour and alpha of the most cells.
constexpr std::uintmax_t longest_image = std::uintmax_t{8} * OccupancyGrid::max_cells;
constexpr std::string_view expected = "a PNG, BMP or Netpbm (PGM, PPM, PBM) picture";

std::string_view foreign_format(std::string_view bytes) {
  if (bytes.starts_with("\xff\xd8\xff")) return "a JPEG";
  if (bytes.starts_with("GIF8")) return "a GIF";
  if (bytes.starts_with(std::string_view("II*\0", 4)) || bytes.starts_with(std::string_view("MM\0*", 4)))
    return "a TIFF";
  if (bytes.starts_with("RIFF") && bytes.substr(0, 12).ends_with("WEBP")) return "a WebP";
  if (bytes.starts_with("<svg") || bytes.starts_with("<?xml")) return "an SVG or XML";
  return {};
}

}  // namespace

GreyImage read_image(const std::filesystem::path& file) {
  return parse_image(whole_file(file, longest_image), file.string());
}

GreyImage parse_image(std::string_view bytes, const std::string& name) {
  if (bytes.starts_with("\x89PNG")) return parse_png(bytes, name);
  if (bytes.starts_with("BM")) return parse_bmp(bytes, name);
  if (bytes.starts_with("P")) return parse_pnm(bytes, name);
  if (bytes.empty()) fail_in(name, fmt::format("the file is empty; expected {}", expected));
  const std::string_view foreign = foreign_format(bytes);
  if (!foreign.empty()) fail_in(name, fmt::format("is {}; expected {}", foreign, expected));
  fail_in(name, fmt::format("begins with '{}'; expected {}", printable(bytes.substr(0, 8)), expected));
}

}  // namespace pathrace::scenarios
