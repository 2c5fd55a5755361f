#include "results/svg.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>
#include <sstream>
#include <vector>

#include "results/xml.hpp"
#include "tests/support/maps.hpp"
#include "tests/support/xml_fault.hpp"

namespace pathrace::results {
namespace {

using pathrace::testing::grid_of;
using pathrace::testing::random_grid;
using pathrace::testing::terrain_of;
using pathrace::testing::xml_fault;

Scenario scenario_on(const OccupancyGrid& grid, Cell start, Cell goal) {
  Scenario scenario;
  scenario.id = "test";
  scenario.terrain = terrain_of(grid);
  scenario.start = start;
  scenario.goal = goal;
  return scenario;
}

std::string svg(const Scenario& scenario, const Answer& answer, const std::string& title = "a title") {
  std::ostringstream out;
  write_svg(out, scenario, {title, answer});
  return out.str();
}

std::size_t count(const std::string& text, const std::string& piece) {
  std::size_t found = 0;
  for (std::size_t at = text.find(piece); at != std::string::npos; at = text.find(piece, at + 1)) ++found;
  return found;
}

double attribute(const std::string& text, const std::string& name) {
  return std::atof(text.c_str() + text.find(" " + name + "=\"") + name.size() + 3);
}

TEST(XmlCheck, FindsWhatIsWrong) {
  EXPECT_EQ(xml_fault("<a x=\"1\"><b/>text &amp; more</a>\n"), "");
  for (const char* broken : {"", "<a>", "<a></b>", "<a/><a/>", "<a x=1/>", "<a x=\"1/>", "<a>&</a>",
                             "<a>&nbsp;</a>", "x<a/>", "<a x=\"<\"/>", "<a"}) {
    EXPECT_NE(xml_fault(broken), "") << broken;
  }
}

TEST(Svg, IsWellFormed) {
  const Scenario scenario = scenario_on(grid_of({"..#", "#..", "..."}), {0, 0}, {2, 2});
  EXPECT_EQ(xml_fault(svg(scenario, lattice_path({{0, 0}, {1, 0}, {1, 1}, {2, 2}}))), "");
  EXPECT_EQ(xml_fault(svg(scenario, std::nullopt)), "");
  EXPECT_EQ(xml_fault(svg(scenario, Path{})), "");
}

TEST(Svg, IsWellFormedWhateverTheTitle) {
  const Scenario scenario = scenario_on(grid_of({".."}), {0, 0}, {1, 0});
  for (const std::string& title :
       {std::string("<b> & \"q\" 'a' ]]>"), std::string(5000, '&'), std::string("nul \0 bell \a", 12),
        std::string("bad \xFF\xC3 utf-8"), std::string(300, '\xC3'), std::string()}) {
    const std::string picture = svg(scenario, std::nullopt, title);
    EXPECT_EQ(xml_fault(picture), "");
    EXPECT_EQ(picture.find('\0'), std::string::npos);
    EXPECT_EQ(picture.find('\xFF'), std::string::npos);
  }
}

std::string svg_of(const Scenario& scenario, const Shown& shown) {
  std::ostringstream out;
  write_svg(out, scenario, shown);
  return out.str();
}

TEST(Svg, SaysHowATrialWithoutAnAnswerEnded) {
  const Scenario scenario = scenario_on(grid_of({"...", "..."}), {0, 0}, {2, 1});
  EXPECT_NE(svg_of(scenario, {.title = "t", .verdict = Verdict::no_path}).find(">no path  "),
            std::string::npos);
  const std::string gave_up = svg_of(scenario, {.title = "t", .verdict = Verdict::gave_up});
  EXPECT_NE(gave_up.find(">gave up  "), std::string::npos) << gave_up;
  EXPECT_EQ(gave_up.find("stroke-dasharray"), std::string::npos);
}

TEST(Svg, DrawsAPathThatIsNoAnswerDashed) {
  const Scenario scenario = scenario_on(grid_of({"....", "...."}), {0, 0}, {3, 0});
  const Path path = lattice_path({{0, 0}, {1, 0}, {2, 0}});
  const std::string line = "points=\"0,0 2,0\"";
  const std::string refused = svg_of(scenario, {"t", path, Track::lattice, Verdict::invalid});
  const std::string approximate =
      svg_of(scenario, {"t", {}, Track::lattice, Verdict::budget, {{}, {{0, 0}, {2, 0}}, {}, {}}});
  for (const std::string& picture : {refused, approximate}) {
    EXPECT_EQ(count(picture, line), 1U) << picture;
    EXPECT_EQ(count(picture, "stroke-dasharray"), 1U);
    EXPECT_NE(picture.find("dashed: no answer, length 2.00"), std::string::npos);
    EXPECT_EQ(picture.find("no path"), std::string::npos);
  }
  EXPECT_NE(refused.find(">invalid  "), std::string::npos);
  EXPECT_NE(approximate.find(">budget  "), std::string::npos);
  const std::string solved = svg_of(scenario, {"t", path, Track::lattice, Verdict::solved});
  EXPECT_EQ(solved.find("stroke-dasharray"), std::string::npos);
  EXPECT_NE(solved.find(">length 2.00  "), std::string::npos);
}

TEST(Svg, StatesTheOptimumOfItsOwnTrack) {
  Scenario scenario = scenario_on(grid_of({"...", "..."}), {0, 0}, {2, 1});
  scenario.optimum = {true, LatticeLength{1, 1}};  // 2.41
  EXPECT_EQ(svg_of(scenario, {"t", {}, Track::any_angle, Verdict::gave_up}).find("optimum"),
            std::string::npos);
  scenario.any_angle_optimum = {true, 2.25};
  EXPECT_NE(svg_of(scenario, {"t", {}, Track::any_angle, Verdict::gave_up}).find("optimum 2.25"),
            std::string::npos);
  EXPECT_NE(svg_of(scenario, {"t", {}, Track::lattice, Verdict::gave_up}).find("optimum 2.41"),
            std::string::npos);
}

TEST(Svg, ShowsTitleLengthAndOptimum) {
  Scenario scenario = scenario_on(grid_of({"...", "..."}), {0, 0}, {2, 1});
  scenario.optimum = {true, LatticeLength{1, 1}};
  const std::string picture = svg(scenario, lattice_path({{0, 0}, {1, 0}, {2, 0}, {2, 1}}), "as on <test>");
  EXPECT_NE(picture.find(">as on &lt;test&gt;</text>"), std::string::npos);
  EXPECT_NE(picture.find(">length 3.00 "), std::string::npos);
  EXPECT_NE(picture.find("optimum 2.41 "), std::string::npos);
  EXPECT_NE(svg(scenario, std::nullopt).find(">optimum 2.41 "), std::string::npos);
}

TEST(Svg, DrawsThePathThroughItsCornersOnly) {
  const Scenario scenario = scenario_on(grid_of({"....", "...."}), {0, 0}, {3, 1});
  const std::string picture = svg(scenario, lattice_path({{0, 0}, {1, 0}, {2, 0}, {3, 1}}));
  EXPECT_EQ(count(picture, "points=\"0,0 2,0 3,1\""), 2U);  // a halo and the line
  EXPECT_NE(picture.find("stroke-linejoin=\"round\""), std::string::npos);
}

TEST(Svg, KeepsTheTurningBackOfAPath) {
  const Scenario scenario = scenario_on(grid_of({"...."}), {0, 0}, {1, 0});
  EXPECT_EQ(count(svg(scenario, lattice_path({{0, 0}, {1, 0}, {2, 0}, {1, 0}})), "points=\"0,0 2,0 1,0\""),
            2U);
}

TEST(Svg, LeavesOutPointsThatAreNoNumbers) {
  const Scenario scenario = scenario_on(grid_of({".."}), {0, 0}, {1, 0});
  const Path path{Track::any_angle, {{0, 0}, {std::numeric_limits<double>::quiet_NaN(), 0}, {1, 0}}};
  EXPECT_EQ(count(svg(scenario, path), "points=\"0,0 1,0\""), 2U);
}

TEST(Svg, DrawsEachObstacle) {
  const std::string picture =
      svg(scenario_on(grid_of({"....", ".##.", ".##."}), {0, 0}, {3, 0}), std::nullopt);
  EXPECT_NE(picture.find("d=\"M1 1h2v2h-2z\""), std::string::npos);
}

TEST(Svg, DrawsGridLinesUpToSixtyFourCells) {
  // A grid line of the map runs down its whole height.
  EXPECT_NE(svg(scenario_on(OccupancyGrid(64, 64), {0, 0}, {1, 0}), std::nullopt).find("M63 0v64"),
            std::string::npos);
  EXPECT_EQ(svg(scenario_on(OccupancyGrid(65, 64), {0, 0}, {1, 0}), std::nullopt).find("M63 0v64"),
            std::string::npos);
}

TEST(Svg, HasASensibleSizeForAnyMap) {
  for (const auto& [width, height] : {std::pair(1, 1), std::pair(5, 5), std::pair(20, 20),
                                      std::pair(512, 512), std::pair(1, 3000), std::pair(4000, 7)}) {
    const std::string picture = svg(scenario_on(OccupancyGrid(width, height), {0, 0}, {0, 0}), std::nullopt);
    SCOPED_TRACE(std::to_string(width) + "x" + std::to_string(height));
    EXPECT_EQ(xml_fault(picture), "");
    EXPECT_GE(attribute(picture, "width"), 400);
    EXPECT_LE(attribute(picture, "width"), 1700);
    EXPECT_GE(attribute(picture, "height"), 92);
    EXPECT_LE(attribute(picture, "height"), 1700);
  }
}

TEST(Svg, StaysSmallOnALargeMapOfRooms) {
  OccupancyGrid grid(512, 512);
  for (int i = 0; i < 512; ++i) {
    for (int wall = 31; wall < 512; wall += 32) {
      grid.block({i, wall});
      grid.block({wall, i});
    }
  }
  EXPECT_LT(svg(scenario_on(grid, {0, 0}, {0, 0}), std::nullopt).size(), 20000U);
}

TEST(Svg, IsWellFormedOnRandomMaps) {
  const Stream stream(3);
  for (std::uint64_t i = 0; i < 20; ++i) {
    const OccupancyGrid grid = random_grid(stream.fork(i), 40, 30, 0.3);
    EXPECT_EQ(xml_fault(svg(scenario_on(grid, {0, 0}, {39, 29}), std::nullopt)), "");
  }
}

TEST(XmlText, EscapesMarkupAndDropsWhatXmlCannotHold) {
  EXPECT_EQ(xml_text("a<b>&\"c\"'"), "a&lt;b&gt;&amp;&quot;c&quot;&#39;");
  EXPECT_EQ(xml_text("\xC3\xA9 \xE2\x82\xAC \xF0\x9F\x90\x9C"), "\xC3\xA9 \xE2\x82\xAC \xF0\x9F\x90\x9C");
  EXPECT_EQ(xml_text("\x01\x7F\n"), "???");
  EXPECT_EQ(xml_text("\xC3"), "?");                 // cut short
  EXPECT_EQ(xml_text("\xC0\xAF"), "??");            // an overlong slash
  EXPECT_EQ(xml_text("\xED\xA0\x80"), "???");       // half a surrogate pair
  EXPECT_EQ(xml_text("\xF4\x90\x80\x80"), "????");  // above U+10FFFF
  EXPECT_EQ(xml_text("\xEF\xBF\xBF"), "???");       // U+FFFF is no character
}

}  // namespace
}  // namespace pathrace::results
