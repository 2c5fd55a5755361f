// A pen: draws on a sheet of pixels, whatever the sheet is made of. A picture is laid out once and drawn by
// any pen, so that SVG and PNG cannot drift apart.
//
// x grows to the right, y downwards, (0, 0) is the sheet's upper left corner; the unit is one pixel.
#pragma once

#include <string>
#include <vector>

#include "core/overlay.hpp"
#include "core/planner.hpp"
#include "core/scenario.hpp"
#include "results/picture_style.hpp"

namespace pathrace::results {

enum class Weight { normal, bold };

struct TextStyle {
  int size;  ///< em, in pixels
  Weight weight;
  Colour colour;
};

class Pen {
 public:
  Pen() = default;
  Pen(const Pen&) = delete;
  Pen& operator=(const Pen&) = delete;
  virtual ~Pen() = default;

  /// One line of UTF-8, `baseline` pixels below the top, cut with an ellipsis to `room` pixels.
  virtual void text(double x, double baseline, const TextStyle& style, const std::string& text,
                    double room) = 0;
  /// Pixels from the beginning of a line of text to its end; about that many where the font is the viewer's.
  virtual double text_width(const TextStyle& style, const std::string& text) const = 0;

  /// The map with its frame, overlay, path, start and goal; its upper left corner and the pixels of a cell's
  /// edge.
  virtual void map(double left, double top, double scale, const Scenario& scenario, const Answer& answer,
                   const Overlay& overlay) = 0;
  virtual void rectangle(double left, double top, double width, double height, Colour colour) = 0;
  virtual void disc(Point centre, double radius, Colour colour) = 0;
  /// The line of a circle, `width` pixels thick.
  virtual void ring(Point centre, double radius, double width, Colour colour) = 0;
  /// A polyline with round ends and corners; fewer than two points draw nothing.
  virtual void line(const std::vector<Point>& points, double width, Colour colour) = 0;
  virtual void start_mark(double x, double y, double radius) = 0;
  virtual void goal_mark(double x, double y, double radius) = 0;
  /// A piece of a path, level, as the legend shows it.
  virtual void path_mark(double x, double y, double length) = 0;
};

}  // namespace pathrace::results
