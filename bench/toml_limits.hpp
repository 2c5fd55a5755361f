// What a TOML text must keep to before it is parsed: tables within tables are built and destroyed by
// recursion, so their depth is bounded by the stack.
#pragma once

#include <string>
#include <string_view>

namespace pathrace::bench {

/// Throws InputError "FILE:LINE: ..." for a key of more than 16 parts and for brackets nested more than 32
/// deep.
void require_shallow_toml(std::string_view text, const std::string& file);

}  // namespace pathrace::bench
