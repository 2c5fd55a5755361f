#include "results/xml.hpp"

#include <algorithm>

#include "core/utf8.hpp"

namespace pathrace::results {
namespace {

std::string_view escaped(std::string_view letter) {
  switch (letter.front()) {
    case '&': return "&amp;";
    case '<': return "&lt;";
    case '>': return "&gt;";
    case '"': return "&quot;";
    case '\'': return "&#39;";
    default: break;
  }
  const bool control =
      letter.size() == 1 && (static_cast<unsigned char>(letter.front()) < 0x20 || letter == "\x7F");
  return control ? "?" : letter;
}

}  // namespace

std::string xml_text(std::string_view text) {
  std::string xml;
  while (!text.empty()) {
    const std::size_t size = letter_size(text);
    xml += size == 0 ? "?" : escaped(text.substr(0, size));
    text.remove_prefix(std::max<std::size_t>(1, size));
  }
  return xml;
}

}  // namespace pathrace::results
