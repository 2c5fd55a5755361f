// Foreign text inside an error message: one line, short, printable.
#pragma once

#include <string>
#include <string_view>

namespace pathrace::results {

/// The text in single quotes; control bytes become '?', and what is longer than 60 bytes is cut with "...".
inline std::string quoted(std::string_view text) {
  constexpr std::size_t most = 60;
  std::string line = "'";
  for (const char byte : text.substr(0, most)) {
    line += static_cast<unsigned char>(byte) < 0x20 || byte == 0x7F ? '?' : byte;
  }
  return line + (text.size() > most ? "...'" : "'");
}

}  // namespace pathrace::results
