#include "bench/cli/picture_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "bench/run_folder.hpp"
#include "core/error.hpp"
#include "results/picture_png.hpp"
#include "results/svg.hpp"

namespace pathrace::bench::cli {
namespace {

// ".html, .png or .svg"
std::string listed(const std::vector<std::string>& words) {
  std::string list = words.front();
  for (std::size_t i = 1; i < words.size(); ++i) {
    list += (i + 1 == words.size() ? " or " : ", ") + words[i];
  }
  return list;
}

}  // namespace

void require_extension(const std::string& file, const std::vector<std::string>& extensions) {
  const std::string extension = std::filesystem::path(file).extension().string();
  if (std::find(extensions.begin(), extensions.end(), extension) != extensions.end()) return;
  throw InputError(fmt::format("{}: expected a {} file", file, listed(extensions)));
}

void write_picture(const std::string& file, const Scenario& scenario, const Answer& answer,
                   const std::string& title) {
  require_extension(file, {".png", ".svg"});
  std::ostringstream bytes;
  if (std::filesystem::path(file).extension() == ".png") {
    results::write_png(bytes, scenario, answer, title);
  } else {
    results::write_svg(bytes, scenario, answer, title);
  }
  write_file(file, bytes.str());
}

}  // namespace pathrace::bench::cli
