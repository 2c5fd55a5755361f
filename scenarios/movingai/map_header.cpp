#include "scenarios/movingai/map_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>

#include "core/grid.hpp"

namespace pathrace::scenarios {
namespace {

struct Side {
  int cells = 0;
  int line = 0;  // 0: not given
};

// What the lines before `map` say.
struct Sizes {
  Side height;
  Side width;
  int type_line = 0;  // 0: not given
};

void require_first(int line, std::string_view key, const Lines& lines, const std::string& name) {
  if (line != 0) fail_at(name, lines.number(), fmt::format("'{}' again, after line {}", key, line));
}

void require_given(int line, std::string_view key, const Lines& lines, const std::string& name) {
  if (line == 0) fail_at(name, lines.number(), fmt::format("'map' without '{}' before it", key));
}

Side read_side(std::string_view key, std::string_view value, const Lines& lines, const std::string& name) {
  const std::optional<int> cells = whole_number(value);
  if (!cells || *cells < 1 || *cells > OccupancyGrid::max_side) {
    fail_at(name, lines.number(),
            fmt::format("{} '{}'; expected a whole number from 1 to {}", key, printable(value),
                        OccupancyGrid::max_side));
  }
  return {*cells, lines.number()};
}

void read_entry(std::string_view line, Sizes& sizes, const Lines& lines, const std::string& name) {
  const std::string_view key = line.substr(0, line.find_first_of(" \t"));
  const std::string_view value = trimmed(line.substr(key.size()));
  if (key == "type") {
    require_first(sizes.type_line, key, lines, name);
    if (value != "octile") {
      fail_at(name, lines.number(), fmt::format("type '{}'; expected 'octile'", printable(value)));
    }
    sizes.type_line = lines.number();
  } else if (key == "height" || key == "width") {
    Side& side = key == "height" ? sizes.height : sizes.width;
    require_first(side.line, key, lines, name);
    side = read_side(key, value, lines, name);
  } else {
    fail_at(name, lines.number(),
            fmt::format("'{}' in the header; expected type, height, width or 'map'", printable(line)));
  }
}

// The lines up to and including `map`.
Sizes read_sizes(Lines& lines, const std::string& name) {
  Sizes sizes;
  while (const std::optional<std::string_view> next = lines.next()) {
    const std::string_view line = trimmed(*next);
    if (line == "map") return sizes;
    read_entry(line, sizes, lines, name);
  }
  if (lines.number() == 1) fail_at(name, 1, "the file is empty; expected 'type octile'");
  fail_at(name, lines.number(), "the file ends inside the header; expected type, height, width and 'map'");
}

}  // namespace

MapHeader read_map_header(Lines& lines, const std::string& name) {
  const Sizes sizes = read_sizes(lines, name);
  require_given(sizes.type_line, "type", lines, name);
  require_given(sizes.height.line, "height", lines, name);
  require_given(sizes.width.line, "width", lines, name);
  const MapHeader header{sizes.width.cells, sizes.height.cells, lines.number()};
  if (std::int64_t{header.width} * header.height > OccupancyGrid::max_cells) {
    fail_at(name, std::max(sizes.width.line, sizes.height.line),
            fmt::format("a map of {}x{} cells; expected at most {} in all", header.width, header.height,
                        OccupancyGrid::max_cells));
  }
  return header;
}

void require_plausible_size(const MapHeader& header, std::uintmax_t bytes, const std::string& name) {
  const auto row = static_cast<std::uintmax_t>(header.width) + 2;  // with CRLF
  const std::uintmax_t most = longest_header + 2 * row * static_cast<std::uintmax_t>(header.height);
  if (bytes > most) {
    fail_at(name, header.line,
            fmt::format("the file holds {} bytes; expected at most {} for a map of {}x{} cells", bytes, most,
                        header.width, header.height));
  }
}

}  // namespace pathrace::scenarios
