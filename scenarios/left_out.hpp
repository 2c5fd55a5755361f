// What was to be raced on and cannot be, in a few lines.
#pragma once

#include <string>
#include <vector>

namespace pathrace::scenarios {

struct LeftOut {
  std::string kind;  ///< in the plural: "maps above 512 cells a side"
  std::string what;  ///< one line: which, and why
};

/// One line each; where there are more than three of a kind, two of them and how many more there are.
std::vector<std::string> summary(const std::vector<LeftOut>& left_out);

}  // namespace pathrace::scenarios
