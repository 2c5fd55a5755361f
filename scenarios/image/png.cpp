// PNG through libpng, whose errors are long jumps.
//
// A long jump may not pass over an object with a destructor. So the two functions that set a jump's target,
// read_header and read_rows, hold nothing but plain numbers and pointers, as do the callbacks below them; the
// buffers belong to their caller. What libpng has to say goes into a fixed buffer, never to stderr.
#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <array>
#include <csetjmp>
#include <cstring>

#include "core/error.hpp"
#include "scenarios/image/image_file.hpp"
#include "scenarios/text.hpp"

namespace pathrace::scenarios {
namespace {

struct Source {
  const char* at;
  std::size_t left;
  std::array<char, 128> complaint;
};

struct Header {
  png_uint_32 width;
  png_uint_32 height;
  int channels;  // after the transformations: grey or RGB, with or without alpha
  int depth;     // 8 or 16
};

void keep_complaint(png_structp png, png_const_charp what) {
  auto* const source = static_cast<Source*>(png_get_error_ptr(png));
  std::strncpy(source->complaint.data(), what, source->complaint.size() - 1);
  png_longjmp(png, 1);
}

void ignore_warning(png_structp /*png*/, png_const_charp /*what*/) {}

void take_bytes(png_structp png, png_bytep to, std::size_t count) {
  auto* const source = static_cast<Source*>(png_get_io_ptr(png));
  if (count > source->left) png_error(png, "the file ends too early");
  std::memcpy(to, source->at, count);
  source->at += count;
  source->left -= count;
}

class Reader {
 public:
  explicit Reader(std::string_view bytes)
      : source_{bytes.data(), bytes.size(), {}},
        png_(png_create_read_struct(PNG_LIBPNG_VER_STRING, &source_, keep_complaint, ignore_warning)),
        info_(png_ == nullptr ? nullptr : png_create_info_struct(png_)) {
    if (info_ != nullptr) return;
    png_destroy_read_struct(&png_, nullptr, nullptr);
    throw EnvironmentError("libpng cannot be started");
  }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;
  ~Reader() { png_destroy_read_struct(&png_, &info_, nullptr); }

  // Both return false when libpng complains.
  bool read_header(Header* header) {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;  // NOLINT(cert-err52-cpp): libpng's way
    png_set_read_fn(png_, &source_, take_bytes);
    png_set_user_limits(png_, PNG_UINT_31_MAX, PNG_UINT_31_MAX);  // ours are checked with our words
    png_read_info(png_, info_);
    header->width = png_get_image_width(png_, info_);
    header->height = png_get_image_height(png_, info_);
    png_set_expand(png_);  // palettes to RGB, small greys to 8 bits, tRNS to alpha
    png_set_interlace_handling(png_);
    png_read_update_info(png_, info_);
    header->channels = png_get_channels(png_, info_);
    header->depth = png_get_bit_depth(png_, info_);
    return true;
  }

  bool read_rows(png_bytepp rows) {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;  // NOLINT(cert-err52-cpp)
    png_read_image(png_, rows);
    png_read_end(png_, nullptr);
    return true;
  }

  [[noreturn]] void refuse(const std::string& name) const {
    fail_in(name,
            fmt::format("a damaged PNG: {}; expected a whole one", printable(source_.complaint.data())));
  }

 private:
  Source source_;
  png_structp png_;
  png_infop info_;
};

std::size_t row_bytes(const Header& header) {
  return std::size_t{header.width} * static_cast<std::size_t>(header.channels * header.depth / 8);
}

GreyImage image_of(const std::vector<png_byte>& bytes, const Header& header) {
  const std::uint32_t most = header.depth == 16 ? 65535 : 255;
  const int colours = header.channels >= 3 ? 3 : 1;
  const bool has_alpha = header.channels != colours;
  GreyImage image;
  image.width = static_cast<int>(header.width);
  image.height = static_cast<int>(header.height);
  image.white = most * static_cast<std::uint32_t>(colours);
  image.samples.resize(std::size_t{header.width} * header.height);
  if (has_alpha) {
    image.opaque = static_cast<std::uint16_t>(most);
    image.alpha.resize(image.samples.size());
  }
  const png_byte* at = bytes.data();
  const auto next = [&] {
    std::uint32_t sample = *at++;
    if (header.depth == 16) sample = 256 * sample + *at++;
    return sample;
  };
  for (std::size_t i = 0; i < image.samples.size(); ++i) {
    for (int colour = 0; colour < colours; ++colour) image.samples[i] += next();
    if (has_alpha) image.alpha[i] = static_cast<std::uint16_t>(next());
  }
  return image;
}

}  // namespace

GreyImage parse_png(std::string_view bytes, const std::string& name) {
  Reader reader(bytes);
  Header header{};
  if (!reader.read_header(&header)) reader.refuse(name);
  require_map_size(name, 0, header.width, header.height);
  std::vector<png_byte> raster(row_bytes(header) * header.height);
  std::vector<png_bytep> rows(header.height);
  for (std::size_t y = 0; y < rows.size(); ++y) rows[y] = raster.data() + y * row_bytes(header);
  if (!reader.read_rows(rows.data())) reader.refuse(name);
  return image_of(raster, header);
}

}  // namespace pathrace::scenarios
