// Where the test data lies that is not part of the project.
//
// The environment variable PATHRACE_DATA names the folder; a relative one counts from the repository root.
// Tests that need it skip without the variable, and fail when it names a folder that is not there: a typing
// error must not pass for a green suite. CMake defines PATHRACE_SOURCE_DIR, the repository root.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <optional>

namespace pathrace::testing {

/// Nothing when PATHRACE_DATA is missing or empty.
inline std::optional<std::filesystem::path> data_folder() {
  const char* const value = std::getenv("PATHRACE_DATA");
  if (value == nullptr || *value == '\0') return std::nullopt;
  return std::filesystem::path(PATHRACE_SOURCE_DIR) / value;  // an absolute value stands alone
}

inline constexpr const char* without_data = "the test data is not here: PATHRACE_DATA is not set";

}  // namespace pathrace::testing
