// Cutting text at a separator.
#pragma once

#include <string_view>

namespace pathrace::results {

/// Calls `use` on each piece between separators; none for an empty text.
template <typename Use>
void for_each_piece(std::string_view text, char separator, const Use& use) {
  if (text.empty()) return;
  while (true) {
    const std::size_t end = text.find(separator);
    use(text.substr(0, end));
    if (end == std::string_view::npos) return;
    text.remove_prefix(end + 1);
  }
}

}  // namespace pathrace::results
