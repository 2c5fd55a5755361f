// Pictures byte by byte, from the formats' specifications and without their libraries.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace pathrace::testing {

inline std::string big_endian(std::uint32_t value, int bytes) {
  std::string text;
  for (int i = bytes - 1; i >= 0; --i) text += static_cast<char>(value >> (8 * i) & 0xffU);
  return text;
}

inline std::string little_endian(std::uint32_t value, int bytes) {
  std::string text;
  for (int i = 0; i < bytes; ++i) text += static_cast<char>(value >> (8 * i) & 0xffU);
  return text;
}

/// CRC-32 of PNG (polynomial 0xEDB88320), bit by bit.
inline std::uint32_t crc_of(std::string_view text) {
  std::uint32_t crc = 0xffffffffU;
  for (const char character : text) {
    crc ^= static_cast<unsigned char>(character);
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1U ^ ((crc & 1U) != 0 ? 0xEDB88320U : 0U);
  }
  return ~crc;
}

inline std::string png_chunk(const std::string& type, const std::string& data) {
  return big_endian(static_cast<std::uint32_t>(data.size()), 4) + type + data +
         big_endian(crc_of(type + data), 4);
}

/// A zlib stream of one stored block; at most 65535 bytes.
inline std::string stored(const std::string& data) {
  std::uint32_t a = 1;
  std::uint32_t b = 0;
  for (const char character : data) {
    a = (a + static_cast<unsigned char>(character)) % 65521;
    b = (b + a) % 65521;
  }
  const auto size = static_cast<std::uint32_t>(data.size());
  return "\x78\x01\x01" + little_endian(size, 2) + little_endian(~size & 0xffffU, 2) + data +
         big_endian(b << 16U | a, 4);
}

struct PngForm {
  std::uint32_t width = 1;
  std::uint32_t height = 1;
  char depth = 8;
  char colour = 0;     ///< 0 grey, 2 RGB, 3 palette, 4 grey and alpha, 6 RGBA
  std::string before;  ///< chunks between the header and the pixels
  char interlace = 0;  ///< 1: Adam7
};

inline const std::string png_magic = "\x89PNG\r\n\x1a\n";

/// `raster`: the rows, each with its filter byte.
inline std::string png_of_raster(const PngForm& form, const std::string& raster) {
  const std::string header = big_endian(form.width, 4) + big_endian(form.height, 4) +
                             std::string{form.depth, form.colour, '\0', '\0', form.interlace};
  return png_magic + png_chunk("IHDR", header) + form.before + png_chunk("IDAT", stored(raster)) +
         png_chunk("IEND", "");
}

/// `rows`: the pixels of all rows without filter bytes, `row_bytes` each.
inline std::string png(const PngForm& form, const std::string& rows, std::size_t row_bytes) {
  std::string raster;
  for (std::size_t at = 0; at < rows.size(); at += row_bytes) raster += '\0' + rows.substr(at, row_bytes);
  return png_of_raster(form, raster);
}

struct BmpForm {
  std::uint32_t width = 1;
  std::uint32_t height = 1;  ///< two's complement; negative: top-down
  std::uint32_t bits = 24;
  std::uint32_t compression = 0;
  std::string behind_header;  ///< palette or masks
  std::uint32_t colours = 0;
};

/// A BMP with the header of Windows 3; `rows` with their padding, in the file's order.
inline std::string bmp(const BmpForm& form, const std::string& rows) {
  const auto pixels_at = static_cast<std::uint32_t>(54 + form.behind_header.size());
  return "BM" + little_endian(pixels_at + static_cast<std::uint32_t>(rows.size()), 4) + little_endian(0, 4) +
         little_endian(pixels_at, 4) + little_endian(40, 4) + little_endian(form.width, 4) +
         little_endian(form.height, 4) + little_endian(1, 2) + little_endian(form.bits, 2) +
         little_endian(form.compression, 4) + std::string(12, '\0') + little_endian(form.colours, 4) +
         little_endian(0, 4) + form.behind_header + rows;
}

}  // namespace pathrace::testing
