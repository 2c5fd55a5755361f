#include "scenarios/image/png_writer.hpp"

#include <png.h>

#include <csetjmp>
#include <string>
#include <vector>

#include "core/error.hpp"

namespace pathrace::scenarios {
namespace {

constexpr const char* cannot = "the PNG could not be written";

void jump(png_structp png, png_const_charp /*what*/) {
  png_longjmp(png, 1);
}

void ignore_warning(png_structp /*png*/, png_const_charp /*what*/) {}

void collect(png_structp png, png_bytep bytes, std::size_t count) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(bytes), count);
}

void nothing_to_flush(png_structp /*png*/) {}

class Writer {
 public:
  Writer()
      : png_(png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, jump, ignore_warning)),
        info_(png_ == nullptr ? nullptr : png_create_info_struct(png_)) {
    if (info_ != nullptr) return;
    png_destroy_write_struct(&png_, nullptr);
    throw EnvironmentError(cannot);
  }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;
  ~Writer() { png_destroy_write_struct(&png_, &info_); }

  // False when libpng fails; holds nothing that a long jump would have to destroy.
  bool write(std::string* to, png_uint_32 width, png_uint_32 height, png_bytepp rows) {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;  // NOLINT(cert-err52-cpp): libpng's way
    png_set_write_fn(png_, to, collect, nothing_to_flush);
    png_set_IHDR(png_, info_, width, height, 1, PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_write_info(png_, info_);
    png_write_image(png_, rows);
    png_write_end(png_, nullptr);
    return true;
  }

 private:
  png_structp png_;
  png_infop info_;
};

// Eight cells a byte, the leftmost in the highest bit.
std::vector<png_byte> raster_of(const OccupancyGrid& grid, std::size_t stride) {
  std::vector<png_byte> raster(stride * static_cast<std::size_t>(grid.height()));
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) {
      if (!grid.is_free({x, y})) continue;
      png_byte& byte = raster[static_cast<std::size_t>(y) * stride + static_cast<std::size_t>(x / 8)];
      byte = static_cast<png_byte>(byte | 0x80U >> static_cast<unsigned>(x % 8));
    }
  }
  return raster;
}

}  // namespace

void write_png(std::ostream& out, const OccupancyGrid& grid) {
  const std::size_t stride = (static_cast<std::size_t>(grid.width()) + 7) / 8;
  std::vector<png_byte> raster = raster_of(grid, stride);
  std::vector<png_bytep> rows(static_cast<std::size_t>(grid.height()));
  for (std::size_t y = 0; y < rows.size(); ++y) rows[y] = raster.data() + y * stride;
  Writer writer;
  std::string bytes;
  if (!writer.write(&bytes, static_cast<png_uint_32>(grid.width()), static_cast<png_uint_32>(grid.height()),
                    rows.data())) {
    throw EnvironmentError(cannot);
  }
  if (!out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()))) throw EnvironmentError(cannot);
}

}  // namespace pathrace::scenarios
