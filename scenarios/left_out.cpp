#include "scenarios/left_out.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

namespace pathrace::scenarios {

std::vector<std::string> summary(const std::vector<LeftOut>& left_out) {
  constexpr std::size_t most_lines = 3;
  std::vector<std::string> kinds;
  for (const LeftOut& item : left_out) {
    if (std::find(kinds.begin(), kinds.end(), item.kind) == kinds.end()) kinds.push_back(item.kind);
  }
  std::vector<std::string> lines;
  for (const std::string& kind : kinds) {
    std::vector<std::string> items;
    for (const LeftOut& item : left_out) {
      if (item.kind == kind) items.push_back(item.what);
    }
    const std::size_t shown = items.size() > most_lines ? most_lines - 1 : items.size();
    lines.insert(lines.end(), items.begin(), items.begin() + static_cast<std::ptrdiff_t>(shown));
    if (shown < items.size()) lines.push_back(fmt::format("{} more {}", items.size() - shown, kind));
  }
  return lines;
}

}  // namespace pathrace::scenarios
