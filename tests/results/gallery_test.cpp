#include "results/gallery.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "results/gallery_html.hpp"
#include "tests/support/maps.hpp"
#include "tests/support/png_picture.hpp"
#include "tests/support/xml_fault.hpp"

namespace pathrace::results {
namespace {

using pathrace::testing::grid_of;
using pathrace::testing::terrain_of;
using pathrace::testing::xml_fault;

Tile tile(const std::string& title, const std::string& id) {
  Scenario scenario;
  scenario.id = id;
  scenario.terrain = terrain_of(grid_of({"..#", "#..", "..."}));
  scenario.goal = {2, 2};
  scenario.optimum = {true, LatticeLength{4, 0}};
  return {title, "what " + title + " is", scenario, lattice_path({{0, 0}, {1, 0}, {1, 1}, {2, 1}, {2, 2}})};
}

std::string html(const std::vector<Tile>& tiles) {
  std::ostringstream out;
  write_gallery_html(out, tiles);
  return out.str();
}

std::string svg(const std::vector<Tile>& tiles) {
  std::ostringstream out;
  write_gallery_svg(out, tiles);
  return out.str();
}

std::string png(const std::vector<Tile>& tiles) {
  std::ostringstream out;
  write_gallery_png(out, tiles);
  return out.str();
}

// The page without its doctype, as an XML document.
std::string as_xml(const std::string& page) {
  const std::string doctype = "<!DOCTYPE html>\n";
  EXPECT_TRUE(page.starts_with(doctype));
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + page.substr(doctype.size());
}

std::size_t count(const std::string& text, const std::string& piece) {
  std::size_t found = 0;
  for (std::size_t at = text.find(piece); at != std::string::npos; at = text.find(piece, at + 1)) ++found;
  return found;
}

TEST(Gallery, FactsAreSizeAndOptimum) {
  Scenario scenario = tile("a", "a/1").scenario;
  EXPECT_EQ(facts_of(scenario), "3 \u00d7 3 \u00b7 optimum 4.00");
  scenario.optimum = {true, std::nullopt};
  EXPECT_EQ(facts_of(scenario), "3 \u00d7 3 \u00b7 no way");
  scenario.optimum = {};
  EXPECT_EQ(facts_of(scenario), "3 \u00d7 3");
}

TEST(GalleryHtml, IsWellFormed) {
  EXPECT_EQ(xml_fault(as_xml(html({tile("a", "a/1"), tile("a", "a/2"), tile("b", "b/1")}))), "");
  EXPECT_EQ(xml_fault(as_xml(html({}))), "");
  EXPECT_EQ(xml_fault(as_xml(html({tile("<b> & \"q\"", "x</svg>/'1'")}))), "");
}

TEST(GalleryHtml, HasOneCardForEachFamilyAndOnePictureForEachMap) {
  const std::string page = html({tile("one", "one/1"), tile("one", "one/2"), tile("two", "two/1")});
  EXPECT_EQ(count(page, "<section "), 2U);
  EXPECT_EQ(count(page, "<figure>"), 3U);
  for (const char* text :
       {">one</h2>", ">two</h2>", ">what one is</p>", ">what two is</p>", "<code>one/1</code>",
        "<code>one/2</code>", "<code>two/1</code>", "2 families, 3 maps"}) {
    EXPECT_EQ(count(page, text), 1U) << text;
  }
  EXPECT_EQ(count(page, "points=\"0,0 1,0 1,1 2,1 2,2\""), 6U);  // a halo and a line on each map
}

TEST(GalleryHtml, EachPictureSaysWhatItShows) {
  const std::string page = html({tile("one", "one/1")});
  EXPECT_EQ(count(page, "role=\"img\" aria-label=\"Map one/1, 3 \u00d7 3 \u00b7 optimum 4.00\""), 1U);
  EXPECT_EQ(count(page, "<title>one/1</title>"), 1U);
}

TEST(GalleryHtml, FetchesNothingAndRunsNothing) {
  const std::string page = html({tile("one", "one/1")});
  for (const char* word : {"http", "src=", "href=", "url(", "<script", "@import", "<link"}) {
    EXPECT_EQ(count(page, word), 0U) << word;
  }
}

TEST(GalleryHtml, KnowsEveryPaintThatItUses) {
  const std::string page = html({tile("one", "one/1")});
  for (std::size_t at = page.find("var(--"); at != std::string::npos; at = page.find("var(--", at + 1)) {
    const std::string name = page.substr(at + 4, page.find(')', at) - at - 4);
    EXPECT_GE(count(page, name + ": #"), 2U) << name;  // for light and for dark
  }
}

TEST(GallerySheet, TheSvgIsWellFormedAndNamesEveryFamily) {
  const std::string sheet = svg({tile("one", "one/1"), tile("two", "two/1")});
  EXPECT_EQ(xml_fault(sheet), "");
  for (const char* text :
       {">one</text>", ">two</text>", ">one/1</text>", ">what two is</text>", "optimum 4.00"}) {
    EXPECT_GE(count(sheet, text), 1U) << text;
  }
}

TEST(GallerySheet, LongCaptionsBreakAndAreCutAfterThreeLines) {
  Tile wordy = tile("one", "one/1");
  wordy.caption.clear();
  for (int i = 0; i < 60; ++i) wordy.caption += "word ";
  const std::string sheet = svg({wordy});
  EXPECT_EQ(count(sheet, ">word word"), 3U);
  EXPECT_EQ(count(sheet, "\u2026</text>"), 1U);
}

TEST(GallerySheet, ThePngGrowsARowWithEveryFiveTiles) {
  const auto header = [](std::size_t tiles) {
    return testing::png_header(png(std::vector<Tile>(tiles, tile("one", "one/1"))));
  };
  EXPECT_TRUE(header(1).signature);
  EXPECT_EQ(header(1).width, 1200U);
  EXPECT_EQ(header(5).height, header(1).height);
  const std::uint32_t row = header(6).height - header(5).height;
  EXPECT_GT(row, 208U);  // more than a map
  EXPECT_EQ(header(11).height, header(6).height + row);
}

TEST(GallerySheet, EqualTilesGiveEqualBytes) {
  const std::vector<Tile> tiles = {tile("one", "one/1"), tile("two", "two/1")};
  EXPECT_EQ(png(tiles), png(tiles));
  EXPECT_EQ(html(tiles), html(tiles));
}

}  // namespace
}  // namespace pathrace::results
