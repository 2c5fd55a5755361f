// The pen that writes SVG.
#pragma once

#include <ostream>

#include "results/pen.hpp"

namespace pathrace::results {

/// Begins an SVG 1.1 document with its title and paper when it is made and ends it when `finish` is called.
class SvgPen : public Pen {
 public:
  SvgPen(std::ostream& out, double width, double height, const std::string& title);
  void finish();

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
  std::ostream& out_;
  Palette<std::string> paints_ = css(palette);
};

}  // namespace pathrace::results
