// The map is drawn in cell units inside a scaled and shifted group, so that its numbers are the cells' own;
// everything else is drawn in pixels around it.
#include "results/svg_pen.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include "core/utf8.hpp"
#include "results/svg_map.hpp"
#include "results/xml.hpp"

namespace pathrace::results {
namespace {

constexpr const char* font = "font-family=\"Helvetica, Arial, 'DejaVu Sans', sans-serif\"";
constexpr double letter_width = 0.56;  // em, on average, in a proportional font

std::string fitted(const std::string& text, double room, double size) {
  const auto most = static_cast<std::size_t>(room / (letter_width * size));
  if (letter_count(text) <= most) return text;
  std::string_view rest = text;
  for (std::size_t i = 0; i + 1 < most; ++i) rest.remove_prefix(std::max<std::size_t>(1, letter_size(rest)));
  return text.substr(0, text.size() - rest.size()) + "\u2026";
}

}  // namespace

SvgPen::SvgPen(std::ostream& out, double width, double height, const std::string& title) : out_(out) {
  fmt::print(
      out_,
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\">\n",
      width, height);
  fmt::print(out_, "<title>{}</title>\n<rect width=\"100%\" height=\"100%\" fill=\"{}\"/>\n", xml_text(title),
             paints_.paper);
}

void SvgPen::finish() {
  out_ << "</svg>\n";
}

void SvgPen::text(double x, double baseline, const TextStyle& style, const std::string& text, double room) {
  fmt::print(out_, "<text x=\"{}\" y=\"{}\" {} font-size=\"{}\" font-weight=\"{}\" fill=\"{}\">{}</text>\n",
             x, baseline, font, style.size, style.weight == Weight::bold ? "bold" : "normal",
             css(style.colour), xml_text(fitted(text, room, style.size)));
}

double SvgPen::text_width(const TextStyle& style, const std::string& text) const {
  return static_cast<double>(letter_count(text)) * letter_width * style.size;
}

void SvgPen::map(double left, double top, double scale, const Scenario& scenario, const Answer& answer,
                 const Overlay& overlay) {
  fmt::print(out_, "<g transform=\"translate({} {}) scale({:.6g}) translate(0.5 0.5)\">\n", left, top, scale);
  write_svg_map(out_, scenario, answer, overlay, scale, paints_);
  out_ << "</g>\n";
}

void SvgPen::rectangle(double left, double top, double width, double height, Colour colour) {
  fmt::print(out_, "<rect x=\"{:.6g}\" y=\"{:.6g}\" width=\"{:.6g}\" height=\"{:.6g}\" fill=\"{}\"/>\n", left,
             top, width, height, css(colour));
}

void SvgPen::disc(Point centre, double radius, Colour colour) {
  fmt::print(out_, "<circle cx=\"{:.6g}\" cy=\"{:.6g}\" r=\"{:.6g}\" fill=\"{}\"/>\n", centre.x, centre.y,
             radius, css(colour));
}

void SvgPen::ring(Point centre, double radius, double width, Colour colour) {
  fmt::print(out_,
             "<circle cx=\"{:.6g}\" cy=\"{:.6g}\" r=\"{:.6g}\" fill=\"none\" stroke=\"{}\" "
             "stroke-width=\"{:.4g}\"/>\n",
             centre.x, centre.y, radius, css(colour), width);
}

void SvgPen::line(const std::vector<Point>& points, double width, Colour colour) {
  if (points.size() < 2) return;
  std::string text;
  for (const Point point : points) text += fmt::format("{:.6g},{:.6g} ", point.x, point.y);
  text.pop_back();
  fmt::print(out_,
             "<polyline fill=\"none\" stroke=\"{}\" stroke-width=\"{:.4g}\" stroke-linecap=\"round\" "
             "stroke-linejoin=\"round\" points=\"{}\"/>\n",
             css(colour), width, text);
}

void SvgPen::start_mark(double x, double y, double radius) {
  write_svg_start(out_, x, y, radius, paints_);
}

void SvgPen::goal_mark(double x, double y, double radius) {
  write_svg_goal(out_, x, y, radius, paints_);
}

void SvgPen::path_mark(double x, double y, double length) {
  fmt::print(out_, "<path stroke=\"{}\" stroke-width=\"3\" stroke-linecap=\"round\" d=\"M{} {}h{}\"/>\n",
             paints_.path, x, y, length);
}

}  // namespace pathrace::results
