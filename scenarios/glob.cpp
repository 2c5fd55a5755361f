#include "scenarios/glob.hpp"

namespace pathrace::scenarios {
namespace {

constexpr std::size_t none = std::string_view::npos;

// Bytes of the pattern's set, if the character is in it; 0 otherwise. `close` is its closing bracket.
std::size_t set_size(std::string_view pattern, std::size_t close, char character) {
  const bool negated = pattern[1] == '!' || pattern[1] == '^';
  bool found = false;
  for (std::size_t i = negated ? 2 : 1; i < close; ++i) {
    const bool range = i + 2 < close && pattern[i + 1] == '-';
    const char last = pattern[range ? i + 2 : i];
    found = found || (pattern[i] <= character && character <= last);
    if (range) i += 2;
  }
  return found != negated ? close + 1 : 0;
}

// Bytes of the pattern's first symbol, which is no *, if it stands for the character; 0 otherwise.
std::size_t symbol_size(std::string_view pattern, char character) {
  if (pattern.front() == '?') return character != '/' ? 1 : 0;
  if (pattern.front() == '[') {
    const bool negated = pattern.substr(1).starts_with('!') || pattern.substr(1).starts_with('^');
    const std::size_t close = pattern.find(']', negated ? 3 : 2);  // a ] that comes first is one of the set
    if (close != none) return character != '/' ? set_size(pattern, close, character) : 0;
  }
  const std::size_t size = pattern.front() == '\\' && pattern.size() > 1 ? 2 : 1;
  return pattern[size - 1] == character ? size : 0;
}

}  // namespace

// When the rest does not match, only the last * has to take more: whatever an earlier one would take could be
// left to it.
bool glob_matches(std::string_view pattern, std::string_view text) {
  std::size_t p = 0;
  std::size_t t = 0;
  std::size_t star = none;  // the last * passed
  std::size_t taken = 0;    // where in the text what it stands for ends
  while (t < text.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      taken = t;
      continue;
    }
    const std::size_t size = p < pattern.size() ? symbol_size(pattern.substr(p), text[t]) : 0;
    if (size > 0) {
      p += size;
      ++t;
      continue;
    }
    if (star == none || text[taken] == '/') return false;
    p = star + 1;
    t = ++taken;
  }
  return pattern.find_first_not_of('*', p) == none;
}

}  // namespace pathrace::scenarios
