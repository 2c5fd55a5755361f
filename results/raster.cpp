#include "results/raster.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace pathrace::results {
namespace {

/// Pixels left..right-1, top..bottom-1.
struct Window {
  int left;
  int top;
  int right;
  int bottom;
};

// The pixels of the canvas that a shape with these bounds can touch.
Window window(double left, double top, double right, double bottom, const Canvas& canvas) {
  const auto clamped = [](double value, int most) {
    return static_cast<int>(std::clamp(value, 0.0, static_cast<double>(most)));
  };
  return {clamped(std::floor(left - 1), canvas.width()), clamped(std::floor(top - 1), canvas.height()),
          clamped(std::ceil(right + 1), canvas.width()), clamped(std::ceil(bottom + 1), canvas.height())};
}

Window window(const Segment& segment, double reach, const Canvas& canvas) {
  return window(
      std::min(segment.from.x, segment.to.x) - reach, std::min(segment.from.y, segment.to.y) - reach,
      std::max(segment.from.x, segment.to.x) + reach, std::max(segment.from.y, segment.to.y) + reach, canvas);
}

// From the distance between a pixel's centre and the edge, negative inside.
int coverage_at(double distance) {
  return static_cast<int>(std::lround(std::clamp(0.5 - distance, 0.0, 1.0) * 255));
}

double length_of(Point a) {
  return std::sqrt(a.x * a.x + a.y * a.y);
}

double distance_between(Point a, Point b) {
  return length_of({a.x - b.x, a.y - b.y});
}

double distance_to(const Segment& segment, Point point) {
  const Point along{segment.to.x - segment.from.x, segment.to.y - segment.from.y};
  const Point away{point.x - segment.from.x, point.y - segment.from.y};
  const double square = along.x * along.x + along.y * along.y;
  const double share =
      square > 0 ? std::clamp((along.x * away.x + along.y * away.y) / square, 0.0, 1.0) : 0.0;
  return length_of({away.x - share * along.x, away.y - share * along.y});
}

template <typename Distance>
void paint(Canvas& canvas, const Window& bounds, Colour colour, const Distance& distance) {
  for (int y = bounds.top; y < bounds.bottom; ++y) {
    for (int x = bounds.left; x < bounds.right; ++x) {
      canvas.blend(x, y, colour, coverage_at(distance(Point{x + 0.5, y + 0.5})));
    }
  }
}

Window joined(const Window& a, const Window& b) {
  return {std::min(a.left, b.left), std::min(a.top, b.top), std::max(a.right, b.right),
          std::max(a.bottom, b.bottom)};
}

std::uint8_t mixed(std::uint8_t below, std::uint8_t above, int coverage) {
  return static_cast<std::uint8_t>((below * (255 - coverage) + above * coverage + 127) / 255);
}

}  // namespace

Canvas::Canvas(int width, int height, Colour fill)
    : width_(width),
      height_(height),
      bytes_(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {
  assert(width > 0 && height > 0);
  fill_rectangle(0, 0, width, height, fill);
}

Colour Canvas::at(int x, int y) const {
  const std::size_t i = offset(x, y);
  return {bytes_[i], bytes_[i + 1], bytes_[i + 2]};
}

void Canvas::blend(int x, int y, Colour colour, int coverage) {
  if (coverage == 0) return;
  std::uint8_t* pixel = &bytes_[offset(x, y)];
  pixel[0] = mixed(pixel[0], colour.red, coverage);
  pixel[1] = mixed(pixel[1], colour.green, coverage);
  pixel[2] = mixed(pixel[2], colour.blue, coverage);
}

void Canvas::fill_rectangle(int left, int top, int width, int height, Colour colour) {
  for (int y = std::max(0, top); y < std::min(height_, top + height); ++y) {
    for (int x = std::max(0, left); x < std::min(width_, left + width); ++x) blend(x, y, colour, 255);
  }
}

void Canvas::fill_disc(Point centre, double radius, Colour colour) {
  paint(*this, window({centre, centre}, radius, *this), colour,
        [&](Point pixel) { return distance_between(pixel, centre) - radius; });
}

void Canvas::draw_ring(Point centre, double radius, double width, Colour colour) {
  paint(*this, window({centre, centre}, radius + width / 2, *this), colour,
        [&](Point pixel) { return std::abs(distance_between(pixel, centre) - radius) - width / 2; });
}

void Canvas::stroke(const std::vector<Segment>& segments, double width, Colour colour) {
  if (segments.empty()) return;
  Window all = window(segments.front(), width / 2, *this);
  for (const Segment& segment : segments) all = joined(all, window(segment, width / 2, *this));
  const auto mask_width = static_cast<std::size_t>(all.right - all.left);
  std::vector<std::uint8_t> mask(mask_width * static_cast<std::size_t>(all.bottom - all.top));
  const auto place = [&](int x, int y) {
    return static_cast<std::size_t>(y - all.top) * mask_width + static_cast<std::size_t>(x - all.left);
  };
  for (const Segment& segment : segments) {
    const Window own = window(segment, width / 2, *this);
    for (int y = own.top; y < own.bottom; ++y) {
      for (int x = own.left; x < own.right; ++x) {
        const int coverage = coverage_at(distance_to(segment, {x + 0.5, y + 0.5}) - width / 2);
        std::uint8_t& most = mask[place(x, y)];
        most = std::max(most, static_cast<std::uint8_t>(coverage));
      }
    }
  }
  for (int y = all.top; y < all.bottom; ++y) {
    for (int x = all.left; x < all.right; ++x) blend(x, y, colour, mask[place(x, y)]);
  }
}

std::vector<Segment> segments_of(const std::vector<Point>& points) {
  std::vector<Segment> segments;
  for (std::size_t i = 1; i < points.size(); ++i) segments.push_back({points[i - 1], points[i]});
  if (points.size() == 1) segments.push_back({points[0], points[0]});
  return segments;
}

std::vector<Segment> dashes_of(const std::vector<Point>& points, double dash) {
  std::vector<Segment> dashes;
  bool drawn = true;
  double left = dash;  // of the current piece
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Point a = points[i - 1];
    const Point way = {points[i].x - a.x, points[i].y - a.y};
    const double length = std::sqrt(way.x * way.x + way.y * way.y);
    const auto at = [&](double s) { return Point{a.x + way.x * (s / length), a.y + way.y * (s / length)}; };
    for (double s = 0; s < length;) {
      const double step = std::min(left, length - s);
      if (drawn) dashes.push_back({at(s), at(s + step)});
      s += step;
      left -= step;
      if (left > 0) break;
      left = dash;
      drawn = !drawn;
    }
  }
  return dashes;
}

}  // namespace pathrace::results
