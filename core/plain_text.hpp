// Text that a terminal shows as it is.
//
// A name may come from anywhere: an escape sequence in it would command the terminal, a line end break a
// table, a mark of direction make it read as another name.
#pragma once

#include <string>
#include <string_view>

namespace pathrace {

/// Whether the text is UTF-8 without control characters (C0, DEL, C1), line and paragraph separators, spaces
/// of no width, and marks that turn the direction of writing.
bool is_plain_text(std::string_view text);

/// The text with every byte that is not plain as \xNN.
std::string escape_controls(std::string_view text);

/// Throws InputError "WHERE: WHAT '...'; expected a name without control characters" when it is not plain;
/// without "WHERE: " when `where` is empty.
void require_plain_name(std::string_view where, std::string_view what, std::string_view name);

}  // namespace pathrace
