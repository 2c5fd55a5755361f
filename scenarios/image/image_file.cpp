#include "scenarios/image/image_file.hpp"

#include <fmt/format.h>

#include "scenarios/file_bytes.hpp"
#include "scenarios/text.hpp"

namespace pathrace::scenarios {
namespace {

// Sixteen million cells of 16-bit colour and alpha take 128 MiB; as text they may take twice that.
constexpr std::uintmax_t longest_image = std::uintmax_t{256} << 20;

}  // namespace

GreyImage read_image(const std::filesystem::path& file) {
  return parse_image(whole_file(file, longest_image), file.string());
}

GreyImage parse_image(std::string_view bytes, const std::string& name) {
  if (bytes.starts_with("\x89PNG")) return parse_png(bytes, name);
  if (bytes.starts_with("BM")) return parse_bmp(bytes, name);
  if (bytes.starts_with("P")) return parse_pnm(bytes, name);
  if (bytes.empty()) fail_in(name, "the file is empty; expected a PGM, PNG or BMP picture");
  fail_in(name,
          fmt::format("begins with '{}'; expected a PGM, PNG or BMP picture", printable(bytes.substr(0, 8))));
}

}  // namespace pathrace::scenarios
