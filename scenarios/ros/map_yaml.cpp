#include "scenarios/ros/map_yaml.hpp"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>

#include "core/error.hpp"
#include "scenarios/file_bytes.hpp"
#include "scenarios/image/image_file.hpp"
#include "scenarios/text.hpp"

namespace pathrace::scenarios {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t longest_yaml = std::uintmax_t{1} << 20;

int line_of(const YAML::Mark& mark) {
  return mark.is_null() ? 1 : mark.line + 1;
}

std::string shown(const YAML::Node& node) {
  if (node.IsScalar()) return fmt::format("'{}'", printable(node.Scalar()));
  if (node.IsSequence()) return fmt::format("a list of {}", node.size());
  return node.IsMap() ? "a map" : "nothing";
}

// The yaml's keys, each once.
class Keys {
 public:
  Keys(const YAML::Node& root, std::string name) : name_(std::move(name)) {
    if (!root.IsMap()) fail_at(name_, line_of(root.Mark()), wanted_instead_of(root));
    for (const auto& entry : root) {
      if (!entry.first.IsScalar()) continue;  // a key that is none of ours
      if (!nodes_.emplace(entry.first.Scalar(), entry.second).second) {
        fail_at(name_, line_of(entry.first.Mark()),
                fmt::format("'{}' again; expected it once", printable(entry.first.Scalar())));
      }
    }
  }

  bool has(const std::string& key) const { return nodes_.count(key) != 0; }

  const YAML::Node& required(const std::string& key) const {
    const auto found = nodes_.find(key);
    if (found == nodes_.end()) {
      fail_at(name_, 1, fmt::format("no '{}'; expected image, resolution and origin", key));
    }
    return found->second;
  }

  [[noreturn]] void refuse(const std::string& key, std::string_view expected) const {
    const YAML::Node& node = required(key);
    fail_at(name_, line_of(node.Mark()), fmt::format("{} {}; expected {}", key, shown(node), expected));
  }

  // Not a number when it is none.
  double number(const std::string& key) const { return number_in(required(key)); }

  static double number_in(const YAML::Node& node) {
    const double value = node.IsScalar() ? node.as<double>(std::numeric_limits<double>::quiet_NaN())
                                         : std::numeric_limits<double>::quiet_NaN();
    return std::isfinite(value) ? value : std::numeric_limits<double>::quiet_NaN();
  }

  double share(const std::string& key, double otherwise) const {
    if (!has(key)) return otherwise;
    const double value = number(key);
    if (!(value >= 0 && value <= 1)) refuse(key, "a number from 0 to 1");
    return value;
  }

 private:
  static std::string wanted_instead_of(const YAML::Node& root) {
    return fmt::format("{} at the top; expected a map of image, resolution and origin", shown(root));
  }

  std::string name_;
  std::map<std::string, YAML::Node> nodes_;
};

void read_place(const Keys& keys, MapYaml& yaml) {
  yaml.resolution = keys.number("resolution");
  if (!(yaml.resolution > 0)) keys.refuse("resolution", "metres per cell, a number above 0");
  const std::string form = "three numbers [x, y, yaw]";
  const YAML::Node& origin = keys.required("origin");
  if (!origin.IsSequence() || origin.size() != 3) keys.refuse("origin", form);
  double values[3] = {};
  for (std::size_t i = 0; i < 3; ++i) {
    values[i] = Keys::number_in(origin[i]);
    if (std::isnan(values[i])) keys.refuse("origin", fmt::format("{}; {} is none", form, shown(origin[i])));
  }
  yaml.origin = {values[0], values[1]};
  yaml.yaw = values[2];
}

void read_rule(const Keys& keys, OccupancyRule& rule) {
  rule.occupied_thresh = keys.share("occupied_thresh", rule.occupied_thresh);
  rule.free_thresh = keys.share("free_thresh", rule.free_thresh);
  if (rule.free_thresh > rule.occupied_thresh) {
    keys.refuse(keys.has("free_thresh") ? "free_thresh" : "occupied_thresh",
                fmt::format("free_thresh to be at most occupied_thresh, {} > {}", rule.free_thresh,
                            rule.occupied_thresh));
  }
  if (keys.has("negate")) {
    const YAML::Node& node = keys.required("negate");
    const std::string text = node.IsScalar() ? node.Scalar() : "";
    bool yes = text == "1";
    if (!yes && text != "0" && !YAML::convert<bool>::decode(node, yes)) keys.refuse("negate", "0 or 1");
    rule.negate = yes;
  }
  if (keys.has("mode")) {
    const YAML::Node& node = keys.required("mode");
    for (const auto& [mode, text] : names_of<OccupancyMode>) {
      if (node.IsScalar() && node.Scalar() == text) {
        rule.mode = mode;
        return;
      }
    }
    keys.refuse("mode", "trinary, scale or raw");
  }
}

// "~/x.pgm" lies in the home folder; a relative path beside the yaml, an absolute one stands alone.
fs::path picture_path(const std::string& image, const fs::path& yaml) {
  const char* const home = std::getenv("HOME");
  if (image.starts_with("~/") && home != nullptr) return fs::path(home) / image.substr(2);
  return yaml.parent_path() / image;
}

}  // namespace

MapYaml MapYaml::read(const fs::path& file) {
  return parse(whole_file(file, longest_yaml), file);
}

MapYaml MapYaml::parse(std::string_view text, const fs::path& file) {
  const std::string name = file.string();
  try {
    const Keys keys(YAML::Load(std::string(text_of(text, name))), name);
    MapYaml yaml;
    const YAML::Node& image = keys.required("image");
    if (!image.IsScalar() || image.Scalar().empty()) keys.refuse("image", "the path of a picture");
    yaml.image = picture_path(image.Scalar(), file);
    yaml.image_line = line_of(image.Mark());
    read_place(keys, yaml);
    read_rule(keys, yaml.rule);
    return yaml;
  } catch (const YAML::Exception& fault) {
    fail_at(name, line_of(fault.mark),
            fmt::format("no yaml, in column {}: {}; expected a map of image, resolution and origin",
                        fault.mark.is_null() ? 1 : fault.mark.column + 1, printable(fault.msg)));
  }
}

bool may_be_ros_map(const fs::path& file) {
  if (size_of_file(file) > longest_yaml) return false;
  try {
    const YAML::Node root = YAML::Load(whole_file(file, longest_yaml));
    return root.IsMap() && root["image"].IsDefined();
  } catch (const YAML::Exception&) {
    return true;  // broken: whose it is cannot be told
  }
}

OccupancyMap read_ros_map(const fs::path& file) {
  const MapYaml yaml = MapYaml::read(file);
  std::error_code unreachable;
  if (!fs::is_regular_file(yaml.image, unreachable)) {
    fail_at(file.string(), yaml.image_line,
            fmt::format("image '{}'; expected a picture, and there is no such file",
                        printable_name(yaml.image.string())));
  }
  const GreyImage image = read_image(yaml.image);
  return {image, yaml.rule, {image.width, image.height, yaml.resolution, yaml.origin, yaml.yaw}};
}

}  // namespace pathrace::scenarios
