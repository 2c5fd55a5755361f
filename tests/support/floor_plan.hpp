// The floor plan: which room may include what. A forbidden include builds without a complaint, so a test
// reads every source file and compares it with this plan.
//
// A tree is its files' texts by path, "core/grid.hpp" and so on; a complaint is one line, "path:line: why".
// Standard and POSIX headers are welcome everywhere, but for <random>, whose distributions differ between
// libraries.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace pathrace::testing {

using Tree = std::map<std::string, std::string>;

/// Every source file of the six rooms below the folder.
Tree read_tree(const std::filesystem::path& root);

/// What one file includes or calls against the plan.
std::vector<std::string> complaints(const std::string& path, std::string_view text);

/// The same for every file, and what judges and players reach through the headers that they include.
std::vector<std::string> complaints(const Tree& tree);

}  // namespace pathrace::testing
