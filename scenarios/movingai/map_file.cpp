#include "scenarios/movingai/map_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "scenarios/file_bytes.hpp"
#include "scenarios/movingai/map_header.hpp"
#include "scenarios/text.hpp"

namespace pathrace::scenarios {
namespace {

enum class Surface { ground, water, wall, unknown };

constexpr Surface surface_of(char character) {
  switch (character) {
    case '.':
    case 'G':
    case 'S': return Surface::ground;
    case 'W': return Surface::water;
    case '@':
    case 'O':
    case 'T': return Surface::wall;
    default: return Surface::unknown;
  }
}

void require_cells(std::string_view row, const MapHeader& header, const Lines& lines,
                   const std::string& name) {
  if (row.size() != static_cast<std::size_t>(header.width)) {
    fail_at(name, lines.number(),
            fmt::format("a row of {} cells '{}'; expected {}, the header's width", row.size(), printable(row),
                        header.width));
  }
  const auto stranger = std::find_if(
      row.begin(), row.end(), [](char character) { return surface_of(character) == Surface::unknown; });
  if (stranger != row.end()) {
    fail_at(name, lines.number(),
            fmt::format("'{}' in column {}; expected one of . G S W @ O T",
                        printable(std::string_view(&*stranger, 1)), stranger - row.begin()));
  }
}

// The rows below the header; together they are exactly the header's cells, each of them known.
std::vector<std::string_view> read_rows(Lines& lines, const MapHeader& header, const std::string& name) {
  std::vector<std::string_view> rows;
  while (std::optional<std::string_view> row = lines.next()) {
    row->remove_suffix(row->size() - (row->find_last_not_of(" \t") + 1));  // npos + 1 is 0
    if (rows.size() == static_cast<std::size_t>(header.height)) {
      fail_at(name, lines.number(),
              fmt::format("'{}' after the last row; expected {} rows, the header's height", printable(*row),
                          header.height));
    }
    require_cells(*row, header, lines, name);
    rows.push_back(*row);
  }
  if (rows.size() < static_cast<std::size_t>(header.height)) {
    fail_at(name, lines.number(),
            fmt::format("the file ends after {} rows; expected {}, the header's height", rows.size(),
                        header.height));
  }
  return rows;
}

std::shared_ptr<const OccupancyGrid> grid_of(const std::vector<std::string_view>& rows,
                                             const MapHeader& header, Surface passable) {
  auto grid = std::make_shared<OccupancyGrid>(header.width, header.height);
  for (int y = 0; y < header.height; ++y) {
    const std::string_view row = rows[static_cast<std::size_t>(y)];
    for (int x = 0; x < header.width; ++x) {
      if (surface_of(row[static_cast<std::size_t>(x)]) != passable) grid->block({x, y});
    }
  }
  return grid;
}

}  // namespace

MapFile MapFile::read(const std::filesystem::path& file) {
  const std::string name = file.string();
  const std::uintmax_t size = size_of_file(file);
  const std::string head = first_bytes(file, std::min(size, longest_header));
  Lines lines(text_of(head, name));
  require_plausible_size(read_map_header(lines, name), size, name);
  return parse(first_bytes(file, size), name);
}

MapFile MapFile::parse(std::string_view text, const std::string& name) {
  Lines lines(text_of(text, name));
  const MapHeader header = read_map_header(lines, name);
  require_plausible_size(header, text.size(), name);
  const std::vector<std::string_view> rows = read_rows(lines, header, name);
  return {grid_of(rows, header, Surface::ground), grid_of(rows, header, Surface::water)};
}

std::shared_ptr<const OccupancyGrid> MapFile::grid_for(Cell start, Cell goal) const {
  return is_water(start) && is_water(goal) ? water_ : ground_;
}

MapFile::MapFile(std::shared_ptr<const OccupancyGrid> ground, std::shared_ptr<const OccupancyGrid> water)
    : ground_(std::move(ground)), water_(std::move(water)) {}

}  // namespace pathrace::scenarios
