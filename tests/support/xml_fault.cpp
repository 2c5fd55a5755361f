#include "tests/support/xml_fault.hpp"

#include <algorithm>
#include <stdexcept>
#include <string_view>

namespace pathrace::testing {
namespace {

/// A strict reader of the XML that we write: one declaration, elements, double-quoted attributes, text, and
/// the five entities of XML itself. `fault` says what is wrong with a document; empty when nothing is.
class XmlReader {
 public:
  static std::string fault(const std::string& xml) {
    try {
      XmlReader reader(xml);
      reader.document();
      return "";
    } catch (const std::runtime_error& error) {
      return error.what();
    }
  }

 private:
  explicit XmlReader(std::string_view rest) : rest_(rest) {}

  void document() {
    take("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    expect("<");
    element();
    if (rest_ != "" && rest_ != "\n") fail("more after the root");
  }

  // What follows the '<' of an opening tag, up to the end of its closing tag.
  void element() {
    const std::string_view name = word();
    while (take(" ")) attribute();
    if (take("/>")) return;
    expect(">");
    while (!take("</")) {
      if (take("<")) {
        element();
      } else {
        character('<');
      }
    }
    if (word() != name) fail("a closing tag of another name");
    expect(">");
  }

  void attribute() {
    word();
    expect("=\"");
    while (!take("\"")) character('"');
  }

  void character(char end) {
    if (rest_.empty()) fail("the document ends too early");
    if (rest_[0] == '<' && end != '<') fail("a bare <");
    if (rest_[0] != '&') return rest_.remove_prefix(1);
    for (const char* entity : {"&amp;", "&lt;", "&gt;", "&quot;", "&#39;"}) {
      if (take(entity)) return;
    }
    fail("a bare &");
  }

  std::string_view word() {
    const std::size_t size = std::min(rest_.find_first_of(" =/>\"<&\n"), rest_.size());
    if (size == 0) fail("no name");
    const std::string_view text = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return text;
  }

  bool take(std::string_view text) {
    if (rest_.substr(0, text.size()) != text) return false;
    rest_.remove_prefix(text.size());
    return true;
  }
  void expect(std::string_view text) {
    if (!take(text)) fail("expected " + std::string(text));
  }
  [[noreturn]] void fail(const std::string& what) const {
    throw std::runtime_error(what + " before: " + std::string(rest_.substr(0, 40)));
  }

  std::string_view rest_;
};

}  // namespace

std::string xml_fault(const std::string& xml) {
  return XmlReader::fault(xml);
}

}  // namespace pathrace::testing
