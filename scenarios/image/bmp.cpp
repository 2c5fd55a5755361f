// BMP without compression.
//
// A file header of 14 bytes (magic, sizes, where the pixels begin), an information header of 40 bytes or
// more, masks or a palette, then rows padded to four bytes, the lowest first unless the height is negative.
// Numbers are little-endian, colours lie as blue, green, red.
#include <fmt/format.h>

#include <array>
#include <bit>
#include <optional>

#include "scenarios/image/image_file.hpp"
#include "scenarios/text.hpp"

namespace pathrace::scenarios {
namespace {

constexpr std::size_t file_header = 14;
constexpr std::size_t least_information = 40;
constexpr std::size_t masks_at = file_header + least_information;
constexpr std::uint32_t plain = 0;
constexpr std::uint32_t by_masks = 3;

class Bytes {
 public:
  Bytes(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name) {}

  std::uint32_t byte(std::size_t at) const {
    require(at + 1);
    return static_cast<unsigned char>(bytes_[at]);
  }
  std::uint32_t two(std::size_t at) const { return byte(at) | byte(at + 1) << 8U; }
  std::uint32_t four(std::size_t at) const { return two(at) | two(at + 2) << 16U; }
  void require(std::size_t size) const {
    if (bytes_.size() < size) {
      fail_in(name_, fmt::format("a BMP of {} bytes; expected at least {}", bytes_.size(), size));
    }
  }

 private:
  std::string_view bytes_;
  const std::string& name_;
};

struct Header {
  std::size_t pixels_at = 0;
  std::size_t palette_at = 0;
  std::size_t colours = 0;  // in the palette
  std::size_t bits = 0;     // a pixel
  int width = 0;
  int height = 0;
  bool top_down = false;
  std::array<std::size_t, 3> colour_bytes = {0, 1, 2};  // where they lie in a pixel of 24 or 32 bits
  std::optional<std::size_t> alpha_byte;

  std::size_t stride() const { return (static_cast<std::size_t>(width) * bits + 31) / 32 * 4; }
};

// Where in a pixel the byte lies that a mask means.
std::size_t byte_of_mask(std::uint32_t mask, const std::string& name) {
  const auto shift = static_cast<std::size_t>(std::countr_zero(mask));
  if (mask == 0 || shift % 8 != 0 || mask >> shift != 0xff) {
    fail_in(name, fmt::format("a BMP with the colour mask {:#010x}; expected masks of whole bytes", mask));
  }
  return shift / 8;
}

void read_masks(const Bytes& bytes, std::size_t information, Header& header, const std::string& name) {
  for (std::size_t i = 0; i < 3; ++i) {
    header.colour_bytes[i] = byte_of_mask(bytes.four(masks_at + 4 * i), name);
  }
  if (information < 56) return;
  const std::uint32_t mask = bytes.four(masks_at + 12);
  if (mask != 0) header.alpha_byte = byte_of_mask(mask, name);
}

void read_size(const Bytes& bytes, Header& header, const std::string& name) {
  const std::int64_t width = static_cast<std::int32_t>(bytes.four(18));
  const std::int64_t height = static_cast<std::int32_t>(bytes.four(22));
  require_map_size(name, 0, width, height < 0 ? -height : height);
  header.width = static_cast<int>(width);
  header.height = static_cast<int>(height < 0 ? -height : height);
  header.top_down = height < 0;
}

void require_form(std::uint32_t compression, const Header& header, const std::string& name) {
  if (compression != plain && (compression != by_masks || header.bits != 32)) {
    fail_in(name,
            fmt::format("a BMP of {} bits a pixel with compression {}; expected none (run lengths, JPEG "
                        "and PNG inside a BMP are not read)",
                        header.bits, compression));
  }
  const bool known =
      header.bits == 1 || header.bits == 4 || header.bits == 8 || header.bits == 24 || header.bits == 32;
  if (!known) {
    fail_in(name, fmt::format("a BMP of {} bits a pixel; expected 1, 4, 8, 24 or 32", header.bits));
  }
}

Header read_header(const Bytes& bytes, const std::string& name) {
  bytes.require(masks_at);
  const std::size_t information = bytes.four(14);
  if (information < least_information || information > 1024) {
    fail_in(name, fmt::format("a BMP header of {} bytes; expected 40 or more, as written since Windows 3",
                              information));
  }
  Header header;
  header.pixels_at = bytes.four(10);
  header.bits = bytes.two(28);
  const std::uint32_t compression = bytes.four(30);
  require_form(compression, header, name);
  read_size(bytes, header, name);
  if (compression == by_masks) read_masks(bytes, information, header, name);
  if (header.bits > 8) return header;
  header.palette_at = file_header + information;
  header.colours = bytes.four(46) == 0 ? std::size_t{1} << header.bits : bytes.four(46);
  if (header.colours > 256) {
    fail_in(name, fmt::format("a BMP palette of {} colours; expected at most 256", header.colours));
  }
  return header;
}

std::uint32_t colour_sum(const Bytes& bytes, const Header& header, std::size_t at) {
  std::uint32_t sum = 0;
  for (const std::size_t offset : header.colour_bytes) sum += bytes.byte(at + offset);
  return sum;
}

std::vector<std::uint32_t> read_palette(const Bytes& bytes, const Header& header) {
  std::vector<std::uint32_t> palette;
  for (std::size_t i = 0; i < header.colours; ++i) {
    palette.push_back(colour_sum(bytes, header, header.palette_at + 4 * i));
  }
  return palette;
}

std::uint32_t palette_index(const Bytes& bytes, const Header& header, std::size_t row, std::size_t x) {
  const std::size_t per_byte = 8 / header.bits;
  const std::size_t shift = (per_byte - 1 - x % per_byte) * header.bits;
  return bytes.byte(row + x / per_byte) >> shift & ((1U << header.bits) - 1);
}

void add_colours(const Bytes& bytes, const Header& header, std::size_t row, GreyImage& image) {
  for (std::size_t x = 0; x < static_cast<std::size_t>(image.width); ++x) {
    const std::size_t at = row + x * header.bits / 8;
    image.samples.push_back(colour_sum(bytes, header, at));
    if (!header.alpha_byte) continue;
    image.alpha.push_back(static_cast<std::uint16_t>(bytes.byte(at + *header.alpha_byte)));
  }
}

void add_looked_up(const Bytes& bytes, const Header& header, const std::vector<std::uint32_t>& palette,
                   std::size_t row, GreyImage& image, const std::string& name) {
  for (std::size_t x = 0; x < static_cast<std::size_t>(image.width); ++x) {
    const std::uint32_t colour = palette_index(bytes, header, row, x);
    if (colour >= palette.size()) {
      fail_in(name, fmt::format("colour {} in the row at byte {}; expected one of the palette's {}", colour,
                                row, palette.size()));
    }
    image.samples.push_back(palette[colour]);
  }
}

}  // namespace

GreyImage parse_bmp(std::string_view bytes, const std::string& name) {
  const Bytes file(bytes, name);
  const Header header = read_header(file, name);
  file.require(header.pixels_at + header.stride() * static_cast<std::size_t>(header.height));
  const std::vector<std::uint32_t> palette = read_palette(file, header);
  GreyImage image;
  image.width = header.width;
  image.height = header.height;
  image.white = 3 * 255;
  image.samples.reserve(image.index(0, image.height));
  if (header.alpha_byte) image.opaque = 255;
  for (int y = 0; y < image.height; ++y) {
    const auto line = static_cast<std::size_t>(header.top_down ? y : image.height - 1 - y);
    const std::size_t row = header.pixels_at + header.stride() * line;
    if (header.bits > 8) {
      add_colours(file, header, row, image);
    } else {
      add_looked_up(file, header, palette, row, image, name);
    }
  }
  return image;
}

}  // namespace pathrace::scenarios
