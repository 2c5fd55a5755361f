// A small canvas of RGB pixels.
//
// Shapes are anti-aliased by their distance to a pixel's centre: coverage falls from 1 to 0 within half a
// pixel on either side of the edge. Only +, -, *, / and sqrt, which IEEE 754 rounds exactly, and rounding to
// integers, so the same drawing gives the same bytes on every machine.
//
// Pixel (x, y) covers x..x+1, y..y+1; (0, 0) is the upper left corner. What lies outside is left out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/cell.hpp"
#include "results/picture_style.hpp"

namespace pathrace::results {

/// A piece of a line, in pixels; both ends may be one point.
struct Segment {
  Point from;
  Point to;
};

class Canvas {
 public:
  /// At least 1 x 1 pixels.
  Canvas(int width, int height, Colour fill);

  int width() const { return width_; }
  int height() const { return height_; }
  Colour at(int x, int y) const;
  /// Red, green, blue of each pixel, row by row from the top.
  const std::vector<std::uint8_t>& bytes() const { return bytes_; }

  /// Lays a colour over a pixel; `coverage` 0 is nothing, 255 all of it.
  void blend(int x, int y, Colour colour, int coverage);

  /// Whole pixels, sharp.
  void fill_rectangle(int left, int top, int width, int height, Colour colour);
  void fill_disc(Point centre, double radius, Colour colour);
  /// The line of a circle, `width` pixels thick, half of them on either side.
  void draw_ring(Point centre, double radius, double width, Colour colour);
  /// All segments as one shape with round ends: where they meet or cross, nothing is painted twice.
  void stroke(const std::vector<Segment>& segments, double width, Colour colour);

 private:
  std::size_t offset(int x, int y) const {
    return 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x));
  }

  int width_;
  int height_;
  std::vector<std::uint8_t> bytes_;
};

/// The segments between neighbours of a polyline; a single point becomes a dot.
std::vector<Segment> segments_of(const std::vector<Point>& points);
/// Every other piece of a polyline, each `dash` long, the first one included.
std::vector<Segment> dashes_of(const std::vector<Point>& points, double dash);

}  // namespace pathrace::results
