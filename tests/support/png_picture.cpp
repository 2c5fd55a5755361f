#include "tests/support/png_picture.hpp"

#include <png.h>

#include <stdexcept>

namespace pathrace::testing {
namespace {

int byte(const std::string& file, std::size_t at) {
  return static_cast<unsigned char>(file.at(at));
}

std::uint32_t number(const std::string& file, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<std::uint32_t>(byte(file, at + i));
  return value;
}

}  // namespace

PngHeader png_header(const std::string& file) {
  PngHeader header;
  header.signature = file.substr(0, 8) == "\x89PNG\r\n\x1a\n";
  header.begins_with_header = number(file, 8) == 13 && file.substr(12, 4) == "IHDR";
  header.width = number(file, 16);
  header.height = number(file, 20);
  header.bit_depth = byte(file, 24);
  header.colour_type = byte(file, 25);
  header.interlace = byte(file, 28);
  return header;
}

std::vector<std::string> png_chunks(const std::string& file) {
  std::vector<std::string> names;
  std::size_t at = 8;
  while (at < file.size()) {
    names.push_back(file.substr(at + 4, 4));
    at += 12 + number(file, at);
  }
  if (at != file.size()) throw std::runtime_error("a chunk is longer than the file");
  return names;
}

Pixels png_pixels(const std::string& file) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_memory(&image, file.data(), file.size()) == 0) {
    throw std::runtime_error(image.message);
  }
  image.format = PNG_FORMAT_RGB;
  Pixels pixels{static_cast<int>(image.width), static_cast<int>(image.height), {}};
  pixels.bytes.resize(PNG_IMAGE_SIZE(image));
  if (png_image_finish_read(&image, nullptr, pixels.bytes.data(), 0, nullptr) == 0) {
    throw std::runtime_error(image.message);
  }
  return pixels;
}

}  // namespace pathrace::testing
