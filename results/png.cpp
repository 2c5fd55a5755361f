// libpng's simplified interface: it neither prints nor jumps; what went wrong stands in `message`.
#include "results/png.hpp"

#include <fmt/format.h>
#include <png.h>

#include "core/error.hpp"

namespace pathrace::results {

std::string png_bytes(const Canvas& canvas) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(canvas.width());
  image.height = static_cast<png_uint_32>(canvas.height());
  image.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::string bytes(size, '\0');
  if (png_image_write_to_memory(&image, bytes.data(), &size, 0, canvas.bytes().data(), 0, nullptr) == 0) {
    throw EnvironmentError(fmt::format("a picture of {}x{} pixels cannot be written as PNG: {}",
                                       canvas.width(), canvas.height(), std::string_view(image.message)));
  }
  bytes.resize(size);
  return bytes;
}

}  // namespace pathrace::results
