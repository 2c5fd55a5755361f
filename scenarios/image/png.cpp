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
  int channels;     // after the transformations: grey or RGB, with or without alpha
  int depth;        // 8 or 16
  int stored_bits;  // a pixel in the file
  int passes;       // 1; 7 when interlaced
};

// Nothing that a map needs; passed over unread, since some unpack to far more than they hold.
constexpr png_byte passed_over[] = "iCCP\0zTXt\0iTXt\0tEXt\0sPLT\0eXIf";
constexpr int passed_over_count = 6;
constexpr png_alloc_size_t largest_chunk = 8U << 20U;  // of those that libpng holds in memory
constexpr std::size_t most_inflation = 1032;           // of DEFLATE

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

  // All return false when libpng complains.
  bool read_header(Header* header) {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;  // NOLINT(cert-err52-cpp): libpng's way
    png_set_read_fn(png_, &source_, take_bytes);
    png_set_user_limits(png_, PNG_UINT_31_MAX, PNG_UINT_31_MAX);  // ours are checked with our words
    png_set_chunk_malloc_max(png_, largest_chunk);
    png_set_keep_unknown_chunks(png_, PNG_HANDLE_CHUNK_NEVER, passed_over, passed_over_count);
    png_read_info(png_, info_);
    header->width = png_get_image_width(png_, info_);
    header->height = png_get_image_height(png_, info_);
    header->stored_bits = png_get_bit_depth(png_, info_) * png_get_channels(png_, info_);
    png_set_expand(png_);  // palettes to RGB, small greys to 8 bits, tRNS to alpha
    header->passes = png_set_interlace_handling(png_);
    png_read_update_info(png_, info_);
    header->channels = png_get_channels(png_, info_);
    header->depth = png_get_bit_depth(png_, info_);
    return true;
  }

  bool read_row(png_bytep row) {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;  // NOLINT(cert-err52-cpp)
    png_read_row(png_, row, nullptr);
    return true;
  }

  bool read_end() {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;  // NOLINT(cert-err52-cpp)
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

std::uint32_t big_endian(std::string_view bytes) {
  std::uint32_t value = 0;
  for (const char byte : bytes) value = value << 8U | static_cast<unsigned char>(byte);
  return value;
}

// Bytes of compressed pixels. libpng takes a chunk's length at its word; here it must be in the file.
std::size_t compressed_bytes(std::string_view bytes, const std::string& name) {
  constexpr std::size_t magic = 8;
  constexpr std::size_t around_data = 12;  // length, type and checksum
  std::size_t compressed = 0;
  bytes.remove_prefix(std::min(magic, bytes.size()));
  while (bytes.size() >= around_data) {
    const std::size_t length = big_endian(bytes.substr(0, 4));
    const std::string_view type = bytes.substr(4, 4);
    if (length > bytes.size() - around_data) {
      fail_in(name, fmt::format("a damaged PNG: the file ends too early, inside the chunk '{}' of {} bytes; "
                                "expected a whole one",
                                printable(type), length));
    }
    if (type == "IDAT") compressed += length;
    if (type == "IEND") break;
    bytes.remove_prefix(length + around_data);
  }
  return compressed;
}

void require_room_for_pixels(const Header& header, std::size_t compressed, const std::string& name) {
  const std::size_t pixels = std::size_t{header.width} * header.height;
  const std::size_t stored = pixels * static_cast<std::size_t>(header.stored_bits) / 8;
  if (stored / most_inflation <= compressed) return;
  fail_in(name, fmt::format("a damaged PNG: {}x{} pixels in {} compressed bytes; expected at least {}",
                            header.width, header.height, compressed, stored / most_inflation));
}

GreyImage blank_image(const Header& header) {
  GreyImage image;
  image.width = static_cast<int>(header.width);
  image.height = static_cast<int>(header.height);
  const std::uint16_t most = header.depth == 16 ? 65535 : 255;
  const int colours = header.channels >= 3 ? 3 : 1;
  image.white = most * static_cast<std::uint32_t>(colours);
  image.samples.resize(std::size_t{header.width} * header.height);
  if (header.channels == colours) return image;
  image.opaque = most;
  image.alpha.resize(image.samples.size());
  return image;
}

void take_row(const png_byte* at, const Header& header, std::size_t y, GreyImage& image) {
  const int colours = header.channels >= 3 ? 3 : 1;
  const auto next = [&] {
    std::uint32_t sample = *at++;
    if (header.depth == 16) sample = 256 * sample + *at++;
    return sample;
  };
  for (std::size_t i = y * header.width; i < (y + 1) * header.width; ++i) {
    for (int colour = 0; colour < colours; ++colour) image.samples[i] += next();
    if (!image.alpha.empty()) image.alpha[i] = static_cast<std::uint16_t>(next());
  }
}

}  // namespace

GreyImage parse_png(std::string_view bytes, const std::string& name) {
  const std::size_t compressed = compressed_bytes(bytes, name);
  Reader reader(bytes);
  Header header{};
  if (!reader.read_header(&header)) reader.refuse(name);
  require_map_size(name, 0, header.width, header.height);
  require_room_for_pixels(header, compressed, name);
  GreyImage image = blank_image(header);
  // Each pass over an interlaced picture adds to the rows of the one before; else one row is enough.
  const std::size_t held = header.passes > 1 ? header.height : 1;
  std::vector<png_byte> rows(held * row_bytes(header));
  for (int pass = 1; pass <= header.passes; ++pass) {
    for (std::size_t y = 0; y < header.height; ++y) {
      png_byte* const row = rows.data() + y % held * row_bytes(header);
      if (!reader.read_row(row)) reader.refuse(name);
      if (pass == header.passes) take_row(row, header, y, image);
    }
  }
  if (!reader.read_end()) reader.refuse(name);
  return image;
}

}  // namespace pathrace::scenarios
