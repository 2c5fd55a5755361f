// Patterns of names: * for any characters, ? for one, [a-c] and [!a-c] for one of a set, \\ before a
// character that stands for itself. None of them stands for a slash.
#pragma once

#include <string_view>

namespace pathrace::scenarios {

/// Whether the pattern stands for the whole text. Takes at most as many steps as the product of their
/// lengths.
bool glob_matches(std::string_view pattern, std::string_view text);

}  // namespace pathrace::scenarios
