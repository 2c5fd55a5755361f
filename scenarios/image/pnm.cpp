// Netpbm pictures, text and binary.
//
// Header: the magic number, width, height and the greatest value, between blanks and comments. One blank,
// then the samples: numbers as text (P2, P3), or bytes (P5, P6), two of them, the high one first, when the
// greatest value is above 255.
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

  // What follows the one blank behind the header.
  std::string_view raster() {
    if (at_ < text_.size() && !is_blank(text_[at_])) {
      fail_at(name_, line_, "no blank after the greatest value; expected one before the samples");
    }
    return text_.substr(std::min(at_ + 1, text_.size()));
  }

 private:
  static std::string wanted(std::string_view what, std::uint32_t low, std::uint32_t high) {
    return fmt::format("{}, a whole number from {} to {}", what, low, high);
  }

  void skip_blanks() {
    while (at_ < text_.size() && (is_blank(text_[at_]) || text_[at_] == '#')) {
      if (text_[at_] == '#') {
        at_ = std::min(text_.find('\n', at_), text_.size());
      } else {
        if (text_[at_] == '\n') ++line_;
        ++at_;
      }
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
  std::uint32_t greatest = 0;

  std::size_t pixels() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
};

Header read_header(Scanner& scanner, char kind, const std::string& name) {
  Header header;
  const std::uint32_t width = scanner.number("the width", 1, 1'000'000'000);
  const std::uint32_t height = scanner.number("the height", 1, 1'000'000'000);
  require_map_size(name, 0, width, height);
  header.width = static_cast<int>(width);
  header.height = static_cast<int>(height);
  header.greatest = scanner.number("the greatest value", 1, greatest_value);
  header.channels = kind == '3' || kind == '6' ? 3 : 1;
  return header;
}

// A picture of text takes at least a digit and a blank a sample: no file of a few bytes makes us reserve
// more.
void require_bytes(std::size_t held, std::size_t needed, const std::string& name) {
  if (held < needed) {
    fail_in(name, fmt::format("holds {} bytes of samples; expected {}, by width, height and greatest value",
                              held, needed));
  }
}

template <typename Next>
std::vector<std::uint32_t> pixel_sums(const Header& header, Next next) {
  std::vector<std::uint32_t> sums(header.pixels());
  for (std::uint32_t& sum : sums) {
    for (std::uint32_t channel = 0; channel < header.channels; ++channel) sum += next();
  }
  return sums;
}

std::vector<std::uint32_t> read_text(Scanner& scanner, const Header& header, const std::string& name) {
  require_bytes(scanner.raster().size() + 1, 2 * header.channels * header.pixels() - 1, name);
  return pixel_sums(header, [&] { return scanner.number("a sample", 0, header.greatest); });
}

std::vector<std::uint32_t> read_bytes(std::string_view raster, const Header& header,
                                      const std::string& name) {
  const std::size_t wide = header.greatest > 255 ? 2 : 1;
  require_bytes(raster.size(), wide * header.channels * header.pixels(), name);
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

}  // namespace

GreyImage parse_pnm(std::string_view bytes, const std::string& name) {
  const char kind = bytes.size() < 2 ? '\0' : bytes[1];
  const bool known = kind == '2' || kind == '3' || kind == '5' || kind == '6';
  if (!bytes.starts_with("P") || !known || (bytes.size() > 2 && !is_blank(bytes[2]) && bytes[2] != '#')) {
    fail_at(name, 1,
            fmt::format("begins with '{}'; expected P2 or P5 (grey), P3 or P6 (colour)",
                        printable(bytes.substr(0, 3))));
  }
  Scanner scanner(bytes, name);
  const Header header = read_header(scanner, kind, name);
  GreyImage image;
  image.width = header.width;
  image.height = header.height;
  image.white = header.channels * header.greatest;
  image.samples = kind < '5' ? read_text(scanner, header, name) : read_bytes(scanner.raster(), header, name);
  return image;
}

}  // namespace pathrace::scenarios
