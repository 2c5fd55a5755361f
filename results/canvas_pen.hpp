// The pen that draws on a canvas of pixels.
#pragma once

#include "results/pen.hpp"
#include "results/raster.hpp"

namespace pathrace::results {

class CanvasPen : public Pen {
 public:
  /// The canvas outlives the pen.
  explicit CanvasPen(Canvas& canvas) : canvas_(canvas) {}

  void text(double x, double baseline, const TextStyle& style, const std::string& text, double room) override;
  double text_width(const TextStyle& style, const std::string& text) const override;
  void map(double left, double top, double scale, const Scenario& scenario, const Answer& answer,
           const Overlay& overlay) override;
  void rectangle(double left, double top, double width, double height, Colour colour) override;
  void disc(Point centre, double radius, Colour colour) override;
  void ring(Point centre, double radius, double width, Colour colour) override;
  void line(const std::vector<Point>& points, double width, Colour colour) override;
  void start_mark(double x, double y, double radius) override;
  void goal_mark(double x, double y, double radius) override;
  void path_mark(double x, double y, double length) override;

 private:
  Canvas& canvas_;
};

}  // namespace pathrace::results
