#include "scenarios/ros/occupancy_map.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

namespace pathrace::scenarios {
namespace {

constexpr int occupied = 100;
constexpr int vacant = 0;

// A brightness as a fraction of whole numbers, so that each p is rounded once.
struct Shade {
  std::uint64_t bright = 0;
  std::uint64_t white = 1;

  double occupied(bool negate) const {
    return static_cast<double>(negate ? bright : white - bright) / static_cast<double>(white);
  }
};

Shade shade_of(const GreyImage& image, std::size_t i) {
  return {image.samples[i], image.white};
}

// Three colours and alpha, in equal parts, where that is darker than the colours alone.
Shade darkened_by_alpha(const GreyImage& image, std::size_t i) {
  if (image.alpha.empty()) return shade_of(image, i);
  const std::uint64_t white = image.white;
  const std::uint64_t opaque = image.opaque;
  if (image.alpha[i] * white >= image.samples[i] * opaque) return shade_of(image, i);
  return {3 * image.samples[i] * opaque + image.alpha[i] * white, 4 * white * opaque};
}

int trinary(double p, const OccupancyRule& rule) {
  if (p > rule.occupied_thresh) return occupied;
  if (p < rule.free_thresh) return vacant;
  return OccupancyMap::unknown;
}

int scaled(double p, const OccupancyRule& rule) {
  const int plain = trinary(p, rule);
  const double range = rule.occupied_thresh - rule.free_thresh;
  if (plain != OccupancyMap::unknown || range <= 0) return plain;
  return static_cast<int>(std::rint((p - rule.free_thresh) / range * 100));
}

int raw(const Shade& shade) {
  const std::uint64_t value = (2 * 255 * shade.bright + shade.white) / (2 * shade.white);
  return value <= occupied ? static_cast<int>(value) : OccupancyMap::unknown;
}

struct Reading {
  int occupancy;
  std::optional<double> p;  // how occupied, where the picture tells
};

Reading read(const GreyImage& image, std::size_t i, const OccupancyRule& rule) {
  switch (rule.mode) {
    case OccupancyMode::trinary: {
      const double p = darkened_by_alpha(image, i).occupied(rule.negate);
      return {trinary(p, rule), p};
    }
    case OccupancyMode::scale: {
      if (!image.alpha.empty() && image.alpha[i] != image.opaque) return {OccupancyMap::unknown, {}};
      const double p = shade_of(image, i).occupied(rule.negate);
      return {scaled(p, rule), p};
    }
    case OccupancyMode::raw: break;
  }
  return {raw(shade_of(image, i)), {}};
}

}  // namespace

OccupancyMap::OccupancyMap(const GreyImage& image, const OccupancyRule& rule, const MapFrame& frame)
    : frame_(frame) {
  assert(frame.width == image.width && frame.height == image.height);
  occupancy_.reserve(image.samples.size());
  likely_.reserve(image.samples.size());
  for (std::size_t i = 0; i < image.samples.size(); ++i) {
    const Reading reading = read(image, i, rule);
    occupancy_.push_back(static_cast<std::int8_t>(reading.occupancy));
    likely_.push_back(reading.p.value_or(1) >= 0.5);
  }
}

std::int64_t OccupancyMap::unknown_cells() const {
  return std::count(occupancy_.begin(), occupancy_.end(), std::int8_t{unknown});
}

OccupancyGrid OccupancyMap::grid(UnknownPolicy policy) const {
  OccupancyGrid grid(width(), height());
  for (int y = 0; y < height(); ++y) {
    for (int x = 0; x < width(); ++x) {
      const Cell cell{x, y};
      const bool by_policy =
          policy == UnknownPolicy::blocked || (policy == UnknownPolicy::threshold && likely_[index(cell)]);
      const int known = occupancy(cell);
      if (known == unknown ? by_policy : known >= blocked_from) grid.block(cell);
    }
  }
  return grid;
}

}  // namespace pathrace::scenarios
