// Comma-separated values (RFC 4180, lines end in a plain newline).
#pragma once

#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace pathrace::results {

/// The text as one field: in double quotes, inner ones doubled, when it holds a comma, a quote or a line end.
/// What a spreadsheet would run as a formula - a text of two letters or more that begins with = + - @, a tab
/// or a carriage return and is no number - gets a ' in front, which spreadsheets take as "this is text".
std::string csv_field(std::string_view text);

void write_csv_line(std::ostream& out, const std::vector<std::string>& fields);

}  // namespace pathrace::results
