#include "scenarios/movingai/scen_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/error.hpp"
#include "scenarios/file_bytes.hpp"
#include "scenarios/text.hpp"

namespace pathrace::scenarios {
namespace {

constexpr std::size_t field_count = 9;
constexpr std::uintmax_t most_bytes = std::uintmax_t{64} << 20;

// One line of nine fields, and where it stands.
struct Fields {
  const std::string& name;
  int line;
  std::vector<std::string_view> values;

  int whole(std::size_t i, std::string_view what) const {
    const std::optional<int> value = whole_number(values[i]);
    if (!value) {
      fail_at(name, line,
              fmt::format("{} '{}'; expected a whole number of at most 32 bits", what, printable(values[i])));
    }
    return *value;
  }

  double length(std::size_t i, std::string_view what) const {
    const std::optional<double> value = real_number(values[i]);
    if (!value || !std::isfinite(*value) || std::signbit(*value)) {
      fail_at(name, line, fmt::format("{} '{}'; expected a number, 0 or more", what, printable(values[i])));
    }
    return *value;
  }
};

// Tabs go first, since a map's name may hold spaces.
std::vector<std::string_view> split_fields(std::string_view line) {
  std::vector<std::string_view> pieces = split_at(line, '\t');
  if (pieces.size() != field_count) return split_at_blanks(line);
  for (std::string_view& piece : pieces) piece = trimmed(piece);
  return pieces;
}

ScenQuery read_query(std::string_view line, int number, const std::string& name) {
  const Fields fields{name, number, split_fields(line)};
  if (fields.values.size() != field_count) {
    fail_at(name, number,
            fmt::format("{} fields '{}'; expected {}: bucket, map, width, height, start x and y, goal x and "
                        "y, optimum",
                        fields.values.size(), printable(line), field_count));
  }
  ScenQuery query;
  query.line = number;
  query.bucket = fields.whole(0, "bucket");
  query.map = std::string(fields.values[1]);
  query.width = fields.whole(2, "width");
  query.height = fields.whole(3, "height");
  query.start = {fields.whole(4, "start x"), fields.whole(5, "start y")};
  query.goal = {fields.whole(6, "goal x"), fields.whole(7, "goal y")};
  query.optimum = fields.length(8, "optimum");
  query.optimum_text = std::string(fields.values[8]);
  return query;
}

void require_version(Lines& lines, const std::string& name) {
  const std::optional<std::string_view> line = lines.next();
  if (!line) fail_at(name, 1, "the file is empty; expected 'version 1'");
  const std::vector<std::string_view> words = split_at_blanks(*line);
  const bool known = words.size() == 2 && words[0] == "version" && (words[1] == "1" || words[1] == "1.0");
  if (!known) fail_at(name, 1, fmt::format("'{}'; expected 'version 1'", printable(*line)));
}

bool has_two_decimals(std::string_view text) {
  const std::size_t dot = text.find('.');
  return dot != std::string_view::npos && text.size() - dot == 3 &&
         text.find_first_not_of("0123456789", dot + 1) == std::string_view::npos;
}

// The power of ten of a positive value's first significant digit.
double leading_unit(double value) {
  double unit = 1;
  while (unit * 10 <= value) unit *= 10;
  while (unit > value) unit /= 10;
  return unit;
}

}  // namespace

ScenFile ScenFile::read(const std::filesystem::path& file) {
  const std::uintmax_t size = size_of_file(file);
  if (size > most_bytes) {
    fail_at(file.string(), 1, fmt::format("the file holds {} bytes; expected at most {}", size, most_bytes));
  }
  ScenFile scen = parse(first_bytes(file, size), file.string());
  scen.file = file;
  return scen;
}

ScenFile ScenFile::parse(std::string_view text, const std::string& name) {
  ScenFile scen{name, {}};
  Lines lines(text_of(text, name));
  require_version(lines, name);
  while (const std::optional<std::string_view> line = lines.next()) {
    if (!trimmed(*line).empty()) scen.queries.push_back(read_query(*line, lines.number(), name));
  }
  if (scen.queries.empty()) fail_at(name, lines.number(), "the file ends here; expected a query");
  return scen;
}

double optimum_tolerance(const ScenQuery& query, double length) {
  const double sixth_digit = query.optimum > 0 ? leading_unit(query.optimum) * 1e-5 : 0;
  const double two_decimals = has_two_decimals(query.optimum_text) ? 0.0051 : 0;
  return std::max({two_decimals, 1e-6 * length + 0.6 * sixth_digit, 1e-6});
}

bool optimum_matches(const ScenQuery& query, double length) {
  return std::isfinite(length) && std::abs(length - query.optimum) <= optimum_tolerance(query, length);
}

std::string map_file_name(std::string_view field) {
  return std::string(field.substr(field.find_last_of("/\\") + 1));  // npos + 1 is 0
}

void require_same_map(const ScenFile& scen, const std::filesystem::path& map_file) {
  const std::string expected = map_file.filename().string();
  for (const ScenQuery& query : scen.queries) {
    if (map_file_name(query.map) != expected) {
      fail_at(scen.file.string(), query.line,
              fmt::format("names map '{}', expected '{}'", printable(query.map), printable_name(expected)));
    }
  }
}

}  // namespace pathrace::scenarios
