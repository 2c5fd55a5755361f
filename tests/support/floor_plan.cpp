#include "tests/support/floor_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>
#include <set>
#include <utility>

namespace pathrace::testing {
namespace {

using Names = std::vector<std::string_view>;

// --- the plan --------------------------------------------------------------------------------------

struct Room {
  std::string_view name;
  Names rooms;      // whose headers it may include, beside its own
  Names libraries;  // by the names in `libraries` below
};

const std::vector<Room>& plan() {
  static const std::vector<Room> rooms = {
      {"core", {}, {"Eigen", "fmt"}},
      {"scenarios", {"core"}, {"fmt", "libpng", "yaml-cpp"}},
      {"algorithms", {"core"}, {"Eigen", "fmt"}},
      {"baselines", {"core"}, {"fmt"}},
      {"baselines/ompl", {"core", "baselines"}, {"fmt", "OMPL"}},
      {"results", {"core"}, {"fmt", "SQLite", "nlohmann-json", "Boost.Math", "libpng"}},
      {"bench",
       {"core", "scenarios", "algorithms", "baselines", "results"},
       {"fmt", "TBB", "OpenMP", "MPI", "CLI11", "toml++", "spdlog", "nlohmann-json"}},
      {"bench/micro",
       {"core", "scenarios", "algorithms", "baselines", "results", "bench"},
       {"fmt", "Google Benchmark"}},
  };
  return rooms;
}

// Beginnings of outside headers, and whose they are.
constexpr std::pair<std::string_view, std::string_view> libraries[] = {
    {"Eigen/", "Eigen"},
    {"fmt/", "fmt"},
    {"png.h", "libpng"},
    {"yaml-cpp/", "yaml-cpp"},
    {"ompl/", "OMPL"},
    {"SQLiteCpp/", "SQLite"},
    {"sqlite3.h", "SQLite"},
    {"nlohmann/", "nlohmann-json"},
    {"boost/math/", "Boost.Math"},
    {"tbb/", "TBB"},
    {"oneapi/", "TBB"},
    {"omp.h", "OpenMP"},
    {"mpi.h", "MPI"},
    {"CLI/", "CLI11"},
    {"toml++/", "toml++"},
    {"spdlog/", "spdlog"},
    {"benchmark/", "Google Benchmark"},
};

const Names posix = {"dirent.h", "fcntl.h",   "immintrin.h", "poll.h", "pthread.h", "pwd.h",
                     "sched.h",  "signal.h",  "spawn.h",     "time.h", "unistd.h",  "sys/",
                     "stdio.h",  "termios.h", "errno.h",     "ext/",   "gnu/"};

// What a file must not reach, neither by itself nor through another header.
struct Ban {
  Names files;    // beginnings of the paths it holds for
  Names headers;  // beginnings of the headers they must not reach
  std::string_view why;
};

const std::vector<Ban>& bans() {
  static const std::vector<Ban> all = {
      {{"algorithms/", "baselines/"},
       {"core/referee.hpp", "core/metrics.hpp", "core/reference/", "core/record.hpp",
        "core/distance_transform.hpp"},
       "a player must not reach what judges it"},
      {{"core/referee.", "core/metrics.", "core/reference/"},
       {"core/moves.hpp", "core/planner.hpp"},
       "a judge must not reach what players use"},
  };
  return all;
}

const std::set<std::string_view> foreign_randomness = {
    "random_device", "mt19937",  "mt19937_64", "default_random_engine", "minstd_rand", "minstd_rand0",
    "ranlux24",      "ranlux48", "knuth_b",    "random_shuffle"};
const std::set<std::string_view> foreign_random_calls = {"rand", "srand", "rand_r", "random", "drand48"};

// --- reading ---------------------------------------------------------------------------------------

bool begins_with_one_of(std::string_view text, const Names& beginnings) {
  return std::any_of(beginnings.begin(), beginnings.end(),
                     [&](std::string_view beginning) { return text.starts_with(beginning); });
}

bool is_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

struct Include {
  std::string header;
  std::size_t line;
};

std::size_t line_of(std::string_view text, std::size_t position) {
  return 1 + static_cast<std::size_t>(
                 std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(position), '\n'));
}

// The header that the first line of a text includes; empty when it includes none.
std::string included_by(std::string_view line) {
  line = line.substr(0, line.find('\n'));
  const auto skip_blanks = [&line] {
    while (!line.empty() && (line[0] == ' ' || line[0] == '\t')) line.remove_prefix(1);
  };
  skip_blanks();
  if (!line.starts_with('#')) return "";
  line.remove_prefix(1);
  skip_blanks();
  if (!line.starts_with("include")) return "";
  line.remove_prefix(7);
  skip_blanks();
  const std::size_t end = line.find_first_of("\">", 1);
  return line.empty() || end == std::string_view::npos ? "" : std::string(line.substr(1, end - 1));
}

// The text with comments, and the insides of string and character literals, replaced by blanks; include
// lines stay whole. Knows nothing of raw strings.
std::string code_of(std::string_view text) {
  std::string code(text);
  const auto blank = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < std::min(end, code.size()); ++i) {
      if (code[i] != '\n') code[i] = ' ';
    }
  };
  for (std::size_t i = 0; i < code.size();) {
    if (code.compare(i, 2, "//") == 0) {
      const std::size_t end = std::min(code.find('\n', i), code.size());
      blank(i, end);
      i = end;
    } else if (code.compare(i, 2, "/*") == 0) {
      const std::size_t close = code.find("*/", i + 2);
      const std::size_t end = close == std::string::npos ? code.size() : close + 2;
      blank(i, end);
      i = end;
    } else if (code[i] == '#' && !included_by(std::string_view(code).substr(i)).empty()) {
      i = code.find_first_of("\">", code.find_first_of("\"<", i) + 1) + 1;
    } else if (code[i] == '"' || (code[i] == '\'' && (i == 0 || !is_word(code[i - 1])))) {
      std::size_t end = i + 1;
      while (end < code.size() && code[end] != code[i] && code[end] != '\n') end += code[end] == '\\' ? 2 : 1;
      blank(i + 1, end);
      i = end + 1;
    } else {
      ++i;
    }
  }
  return code;
}

std::vector<Include> includes_of(std::string_view code) {
  std::vector<Include> includes;
  for (std::size_t begin = 0, line = 1; begin < code.size(); ++line) {
    const std::size_t end = std::min(code.find('\n', begin), code.size());
    std::string header = included_by(code.substr(begin, end - begin));
    if (!header.empty()) includes.push_back({std::move(header), line});
    begin = end + 1;
  }
  return includes;
}

// --- judging ---------------------------------------------------------------------------------------

// The most particular entry of the plan that holds for the path.
const Room* room_of(std::string_view path) {
  const Room* found = nullptr;
  for (const Room& room : plan()) {
    const bool inside = path.starts_with(room.name) && path.substr(room.name.size()).starts_with('/');
    if (inside && (found == nullptr || room.name.size() > found->name.size())) found = &room;
  }
  return found;
}

bool has(const Names& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// Why the room may not include the header; empty when it may.
std::string objection(const Room& room, std::string_view header) {
  const std::string_view folder = header.substr(0, header.find('/'));
  const std::string_view own = room.name.substr(0, room.name.find('/'));
  const bool of_a_room = header.find('/') != std::string_view::npos && room_of(header) != nullptr;
  if (of_a_room) {
    if (folder == own || has(room.rooms, folder)) return "";
    return fmt::format("{} must not include {}", own, folder);
  }
  for (const auto& [beginning, library] : libraries) {
    if (!header.starts_with(beginning)) continue;
    if (has(room.libraries, library)) return "";
    return fmt::format("{} must not use {}", room.name, library);
  }
  if (header == "random") return "random numbers come from core/stream.hpp";
  const bool standard = header.find_first_of("/.") == std::string_view::npos;
  if (standard || begins_with_one_of(header, posix)) return "";
  return "neither a header of a room, by its path from the root, nor of a library in the floor plan";
}

void judge_includes(const std::string& path, const Room& room, std::string_view code,
                    std::vector<std::string>& found) {
  for (const Include& include : includes_of(code)) {
    const std::string why = objection(room, include.header);
    if (!why.empty()) found.push_back(fmt::format("{}:{}: {}: {}", path, include.line, include.header, why));
    for (const Ban& ban : bans()) {
      if (begins_with_one_of(path, ban.files) && begins_with_one_of(include.header, ban.headers)) {
        found.push_back(fmt::format("{}:{}: {}: {}", path, include.line, include.header, ban.why));
      }
    }
  }
}

bool is_foreign_randomness(std::string_view before, std::string_view word, std::string_view after) {
  if (foreign_randomness.count(word) != 0) return true;
  if (word.ends_with("_distribution")) return before.ends_with("std::");
  const bool member = before.ends_with('.') || before.ends_with("->");
  return foreign_random_calls.count(word) != 0 && !member && after.starts_with('(');
}

void judge_randomness(const std::string& path, std::string_view code, std::vector<std::string>& found) {
  for (std::size_t begin = 0; begin < code.size();) {
    if (!is_word(code[begin])) {
      ++begin;
      continue;
    }
    std::size_t end = begin;
    while (end < code.size() && is_word(code[end])) ++end;
    const std::string_view word = code.substr(begin, end - begin);
    const std::size_t next = std::min(code.find_first_not_of(" \t\n", end), code.size());
    if (is_foreign_randomness(code.substr(0, begin), word, code.substr(next))) {
      found.push_back(fmt::format("{}:{}: {}: random numbers come from core/stream.hpp", path,
                                  line_of(code, begin), word));
    }
    begin = end;
  }
}

// Every header of the tree that the file reaches, with the one that includes it.
std::map<std::string, std::string> reached_from(const Tree& tree, const std::string& path) {
  std::map<std::string, std::string> reached;
  std::vector<std::string> frontier{path};
  while (!frontier.empty()) {
    const std::string current = frontier.back();
    frontier.pop_back();
    const auto file = tree.find(current);
    if (file == tree.end()) continue;
    for (const Include& include : includes_of(code_of(file->second))) {
      if (reached.emplace(include.header, current).second) frontier.push_back(include.header);
    }
  }
  return reached;
}

void judge_reach(const Tree& tree, const std::string& path, std::vector<std::string>& found) {
  for (const Ban& ban : bans()) {
    if (!begins_with_one_of(path, ban.files)) continue;
    for (const auto& [header, through] : reached_from(tree, path)) {
      if (through == path || !begins_with_one_of(header, ban.headers)) continue;
      found.push_back(fmt::format("{}: {} through {}: {}", path, header, through, ban.why));
    }
  }
}

}  // namespace

std::vector<std::string> complaints(const std::string& path, std::string_view text) {
  std::vector<std::string> found;
  const Room* room = room_of(path);
  if (room == nullptr) return found;
  const std::string code = code_of(text);
  judge_includes(path, *room, code, found);
  judge_randomness(path, code, found);
  return found;
}

std::vector<std::string> complaints(const Tree& tree) {
  std::vector<std::string> found;
  for (const auto& [path, text] : tree) {
    for (std::string& complaint : complaints(path, text)) found.push_back(std::move(complaint));
    judge_reach(tree, path, found);
  }
  return found;
}

Tree read_tree(const std::filesystem::path& root) {
  Tree tree;
  for (const char* const room : {"core", "scenarios", "algorithms", "baselines", "results", "bench"}) {
    if (!std::filesystem::is_directory(root / room)) continue;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root / room)) {
      const std::string kind = entry.path().extension().string();
      if (kind != ".hpp" && kind != ".cpp" && kind != ".def") continue;
      std::ifstream file(entry.path(), std::ios::binary);
      tree[std::filesystem::relative(entry.path(), root).generic_string()] =
          std::string(std::istreambuf_iterator<char>(file), {});
    }
  }
  return tree;
}

}  // namespace pathrace::testing
