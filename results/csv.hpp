// Comma-separated values (RFC 4180, lines end in a plain newline).
#pragma once

#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace pathrace::results {

/// The text as one field: in double quotes, inner ones doubled, when it holds a comma, a quote or a line end.
inline std::string csv_field(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string field = "\"";
  for (const char letter : text) {
    if (letter == '"') field += '"';
    field += letter;
  }
  return field + '"';
}

inline void write_csv_line(std::ostream& out, const std::vector<std::string>& fields) {
  const char* separator = "";
  for (const std::string& field : fields) {
    out << separator << csv_field(field);
    separator = ",";
  }
  out << '\n';
}

}  // namespace pathrace::results
