// Netpbm pictures, text and binary.
//
// Header: the magic number, width, height and the greatest value (none in PBM), between blanks and comments.
// One blank or line end, then the samples: numbers as text (P1, P2, P3), or bytes (P5, P6), two of them, the
// high one first, when the greatest value is above 255, or bits (P4), rows padded to bytes. In PBM 1 is
// black.
//
// Where binary samples begin shifts every pixel, so their number decides: programs end the header with CRLF
// or put a comment there, which the format does not provide for.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "scenarios/image/image_file.hpp"
#include "scenarios/text.hpp"

namespace pathrace::scenarios {
namespace {

constexpr std::uint32_t greatest_value = 65535;

bool is_blank(char character) {
  return character == ' ' || (character >= '\t' && character <= '\r');
}

bool is_digit(char character) {
  return character >= '0' && character <= '9';
}

// Numbers between blanks and comments, each with the line that it stands on.
class Scanner {
 public:
  Scanner(std::string_view text, const std::string& name) : text_(text), name_(name) {}

  std::uint32_t number(std::string_view what, std::uint32_t low, std::uint32_t high) {
    skip_blanks();
    if (at_ >= text_.size()) {
      fail_at(name_, line_, fmt::format("the file ends; expected {}", wanted(what, low, high)));
    }
    std::size_t end = at_;
    while (end < text_.size() && !is_blank(text_[end]) && text_[end] != '#') ++end;
    const std::string_view word = text_.substr(at_, end - at_);
    std::uint32_t value = 0;
    const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    const bool whole = error == std::errc{} && stop == word.data() + word.size() && is_digit(word[0]);
    if (!whole || value < low || value > high) {
      fail_at(name_, line_, fmt::format("'{}'; expected {}", printable(word), wanted(what, low, high)));
    }
    at_ = end;
    return value;
  }

  // A digit of its own, 0 or 1; PBM needs no blanks between them.
  std::uint32_t bit() {
    skip_blanks();
    if (at_ >= text_.size()) fail_at(name_, line_, "the file ends; expected a pixel, 0 or 1");
    const char digit = text_[at_++];
    if (digit != '0' && digit != '1') {
      fail_at(name_, line_, fmt::format("'{}'; expected a pixel, 0 or 1", printable({&digit, 1})));
    }
    return digit == '1' ? 1 : 0;
  }

  std::size_t left() const { return text_.size() - at_; }

  void require_end() {
    skip_blanks();
    if (left() > 0) {
      fail_at(name_, line_,
              fmt::format("'{}' behind the last sample; expected the end of the file",
                          printable(text_.substr(at_))));
    }
  }

  // The `needed` bytes of samples behind the header.
  std::string_view raster(std::size_t needed) const {
    const std::string_view plain = text_.substr(behind_line_end(at_));
    if (plain.size() == needed) return plain;
    const std::string_view raster = text_.substr(behind_comments());
    const bool ends_with_blanks =
        raster.size() > needed && !is_blank(raster.front()) &&
        std::all_of(raster.begin() + static_cast<std::ptrdiff_t>(needed), raster.end(), is_blank);
    if (raster.size() == needed || ends_with_blanks) return raster.substr(0, needed);
    const bool second = raster.size() > needed && trimmed(raster.substr(needed)).starts_with('P');
    fail_in(name_,
            fmt::format("holds {} bytes of samples; expected {}, by width, height and greatest value{}",
                        raster.size(), needed, second ? ", and no second picture" : ""));
  }

 private:
  static std::string wanted(std::string_view what, std::uint32_t low, std::uint32_t high) {
    return fmt::format("{}, a whole number from {} to {}", what, low, high);
  }

  void skip_blanks() {
    while (at_ < text_.size() && (is_blank(text_[at_]) || text_[at_] == '#')) {
      if (text_[at_] == '#') {
        at_ = std::min(text_.find_first_of("\r\n", at_), text_.size());
      } else {
        if (text_[at_] == '\n') ++line_;
        ++at_;
      }
    }
  }

  // Behind one blank; CR and LF together are one.
  std::size_t behind_line_end(std::size_t at) const {
    const std::size_t size = text_.substr(at, 2) == "\r\n" ? 2 : 1;
    return std::min(at + size, text_.size());
  }

  // Behind the lines of comments that follow the header; behind one blank when none does.
  std::size_t behind_comments() const {
    std::size_t behind = text_.substr(at_).starts_with('#') ? at_ : behind_line_end(at_);
    while (true) {
      const std::size_t comment = std::min(text_.find_first_not_of(" \t\r\n", behind), text_.size());
      const std::size_t end = text_.find_first_of("\r\n", comment);
      if (!text_.substr(comment).starts_with('#') || end == std::string_view::npos) return behind;
      behind = behind_line_end(end);
    }
  }

  std::string_view text_;
  const std::string& name_;
  std::size_t at_ = 2;  // behind the magic number
  int line_ = 1;
};

struct Header {
  int width = 0;
  int height = 0;
  std::uint32_t channels = 1;
  std::uint32_t greatest = 1;

  std::size_t pixels() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
  std::size_t samples() const { return channels * pixels(); }
};

Header read_header(Scanner& scanner, char kind, const std::string& name) {
  Header header;
  const std::uint32_t width = scanner.number("the width", 1, 1'000'000'000);
  const std::uint32_t height = scanner.number("the height", 1, 1'000'000'000);
  require_map_size(name, 0, width, height);
  header.width = static_cast<int>(width);
  header.height = static_cast<int>(height);
  const bool bits = kind == '1' || kind == '4';
  if (!bits) header.greatest = scanner.number("the greatest value", 1, greatest_value);
  header.channels = kind == '3' || kind == '6' ? 3 : 1;
  return header;
}

template <typename Next>
std::vector<std::uint32_t> pixel_sums(const Header& header, Next next) {
  std::vector<std::uint32_t> sums(header.pixels());
  for (std::uint32_t& sum : sums) {
    for (std::uint32_t channel = 0; channel < header.channels; ++channel) sum += next();
  }
  return sums;
}

// No file of a few bytes makes us take more memory: a text holds `least` bytes at least.
std::vector<std::uint32_t> read_text(Scanner& scanner, const Header& header, char kind,
                                     const std::string& name) {
  const std::size_t least = kind == '1' ? header.samples() : 2 * header.samples() - 1;
  if (scanner.left() < least) {
    fail_in(name, fmt::format("holds {} bytes of samples; expected {}, by width, height and greatest value",
                              scanner.left(), least));
  }
  std::vector<std::uint32_t> sums = pixel_sums(header, [&] {
    return kind == '1' ? 1 - scanner.bit() : scanner.number("a sample", 0, header.greatest);
  });
  scanner.require_end();
  return sums;
}

std::vector<std::uint32_t> read_bytes(const Scanner& scanner, const Header& header, const std::string& name) {
  const std::size_t wide = header.greatest > 255 ? 2 : 1;
  const std::string_view raster = scanner.raster(wide * header.samples());
  std::size_t at = 0;
  return pixel_sums(header, [&] {
    std::uint32_t sample = 0;
    for (std::size_t byte = 0; byte < wide; ++byte) {
      sample = 256 * sample + static_cast<unsigned char>(raster[at++]);
    }
    if (sample > header.greatest) {
      fail_in(name, fmt::format("sample {} at byte {} of the raster; expected at most {}, the greatest value",
                                sample, at - wide, header.greatest));
    }
    return sample;
  });
}

std::vector<std::uint32_t> read_bits(const Scanner& scanner, const Header& header) {
  const std::size_t width = static_cast<std::size_t>(header.width);
  const std::size_t stride = (width + 7) / 8;
  const std::string_view raster = scanner.raster(stride * static_cast<std::size_t>(header.height));
  std::size_t x = 0;
  std::size_t row = 0;
  return pixel_sums(header, [&] {
    const auto byte = static_cast<unsigned char>(raster[row * stride + x / 8]);
    const std::uint32_t black = byte >> (7 - x % 8) & 1U;
    if (++x == width) {
      x = 0;
      ++row;
    }
    return 1 - black;
  });
}

}  // namespace

GreyImage parse_pnm(std::string_view bytes, const std::string& name) {
  const char kind = bytes.size() < 2 ? '\0' : bytes[1];
  const bool known = kind >= '1' && kind <= '6';
  if (!bytes.starts_with("P") || !known || (bytes.size() > 2 && !is_blank(bytes[2]) && bytes[2] != '#')) {
    fail_at(name, 1,
            fmt::format("begins with '{}'; expected P1 or P4 (bits), P2 or P5 (grey), P3 or P6 (colour)",
                        printable(bytes.substr(0, 3))));
  }
  Scanner scanner(bytes, name);
  const Header header = read_header(scanner, kind, name);
  GreyImage image;
  image.width = header.width;
  image.height = header.height;
  image.white = header.channels * header.greatest;
  if (kind < '4') {
    image.samples = read_text(scanner, header, kind, name);
  } else {
    image.samples = kind == '4' ? read_bits(scanner, header) : read_bytes(scanner, header, name);
  }
  return image;
}

}  // namespace pathrace::scenarios
