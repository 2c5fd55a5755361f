// A MovingAI scenario file: the `.scen` files of the grid benchmarks.
//
// A line `version 1` (or `1.0`), then one query a line in nine fields: bucket, map, width, height, start
// column and row, goal column and row, optimum. Most files separate with tabs, some with spaces. The optimum
// is the shortest 8-connected way where a diagonal needs both side cells free (MoveRule::strict), printed
// with 2 decimals, 8 decimals or 6 significant digits.
//
// The reader answers for the form only: a query that lies outside its map or starts on a blocked cell is a
// bad query, not a bad file, and is for the caller to count.
//
// N. Sturtevant, "Benchmarks for Grid-Based Pathfinding", IEEE Trans. Computational Intelligence and AI in
// Games 4(2), 2012; https://movingai.com/benchmarks/formats.html
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/cell.hpp"

namespace pathrace::scenarios {

struct ScenQuery {
  int line = 0;     ///< in the file, from 1
  int bucket = 0;   ///< floor(optimum / 4) in files that keep the convention
  std::string map;  ///< as written, often with a folder that exists elsewhere only
  int width = 0;    ///< of the map, in cells
  int height = 0;
  Cell start;
  Cell goal;
  double optimum = 0;        ///< in cell edges, 0 or more
  std::string optimum_text;  ///< as printed in the file
};

struct ScenFile {
  std::filesystem::path file;
  std::vector<ScenQuery> queries;  ///< in the file's order, at least one

  /// Throws InputError "FILE:LINE: the value, what was expected" when the file is no scen file, is missing
  /// ("FILE: no such file") or above 64 MiB; EnvironmentError when the machine refuses to read it.
  static ScenFile read(const std::filesystem::path& file);
  /// The same for a text at hand; `name` stands for the file.
  static ScenFile parse(std::string_view text, const std::string& name);
};

/// What the printing of the optimum leaves open for a way of this length, in cell edges:
/// max(0.0051 if it has two decimals, 1e-6 length + 0.6 unit of the optimum's sixth significant digit, 1e-6).
double optimum_tolerance(const ScenQuery& query, double length);
/// Whether |length - optimum| is within that tolerance; false for a length that is not finite.
bool optimum_matches(const ScenQuery& query, double length);

/// The file name that a scen file's map field means: what follows the last slash or backslash.
std::string map_file_name(std::string_view field);

/// Throws InputError "SCEN:LINE: names map 'x', expected 'y'" when a query belongs to another map than this
/// file. Only file names are compared.
void require_same_map(const ScenFile& scen, const std::filesystem::path& map_file);

}  // namespace pathrace::scenarios
