#include "results/csv.hpp"

#include <charconv>

namespace pathrace::results {
namespace {

bool is_number(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error != std::errc::invalid_argument && end == text.data() + text.size();
}

bool begins_a_formula(std::string_view text) {
  if (text.size() < 2 || std::string_view("=+-@\t\r").find(text.front()) == std::string_view::npos)
    return false;
  return !is_number(text);
}

std::string in_quotes(std::string_view text) {
  std::string field = "\"";
  for (const char letter : text) {
    if (letter == '"') field += '"';
    field += letter;
  }
  return field + '"';
}

}  // namespace

std::string csv_field(std::string_view text) {
  const std::string field = (begins_a_formula(text) ? "'" : "") + std::string(text);
  return field.find_first_of(",\"\r\n") == std::string::npos ? field : in_quotes(field);
}

void write_csv_line(std::ostream& out, const std::vector<std::string>& fields) {
  const char* separator = "";
  for (const std::string& field : fields) {
    out << separator << csv_field(field);
    separator = ",";
  }
  out << '\n';
}

}  // namespace pathrace::results
