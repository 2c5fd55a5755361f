// The scen reader on well-formed files, and how closely an optimum has to be met.
#include "scenarios/movingai/scen_file.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "core/error.hpp"
#include "tests/scenarios/movingai_files.hpp"

namespace pathrace::scenarios {
namespace {

using pathrace::testing::message_of;

ScenFile parse(const std::string& text) {
  return ScenFile::parse(text, "x.scen");
}

ScenQuery query_with_optimum(const std::string& optimum) {
  return parse("version 1\n0\tx.map\t8\t8\t0\t0\t1\t1\t" + optimum + "\n").queries.at(0);
}

TEST(MovingAiScen, NineFieldsAreReadInTheirOrder) {
  const ScenFile scen = parse("version 1\n7\tx.map\t30\t40\t1\t2\t3\t4\t28.5\n");
  ASSERT_EQ(scen.queries.size(), 1U);
  const ScenQuery& query = scen.queries[0];
  EXPECT_EQ(query.line, 2);
  EXPECT_EQ(query.bucket, 7);
  EXPECT_EQ(query.map, "x.map");
  EXPECT_EQ(query.width, 30);
  EXPECT_EQ(query.height, 40);
  EXPECT_EQ(query.start, (Cell{1, 2}));
  EXPECT_EQ(query.goal, (Cell{3, 4}));
  EXPECT_EQ(query.optimum, 28.5);
  EXPECT_EQ(query.optimum_text, "28.5");
}

TEST(MovingAiScen, TheVersionIsOneOrOnePointZero) {
  EXPECT_EQ(parse("version 1\n0 x.map 8 8 0 0 1 1 1.41421").queries.size(), 1U);
  EXPECT_EQ(parse("version 1.0\n0 x.map 8 8 0 0 1 1 1.41421").queries.size(), 1U);
}

TEST(MovingAiScen, AByteOrderMarkIsPassedOver) {
  EXPECT_EQ(parse("\xef\xbb\xbfversion 1\r\n0 x.map 8 8 0 0 1 1 1.41421\r\n").queries.size(), 1U);
}

TEST(MovingAiScen, FieldsAreSeparatedByTabsOrBySpaces) {
  for (const std::string line : {"3\tx.map\t8\t9\t1\t2\t3\t4\t12.5", "3 x.map 8 9 1 2 3 4 12.5",
                                 "3   x.map 8\t9 1 2 3 4 \t12.5 ", " 3\t x.map\t8\t9\t1\t2\t3\t4\t12.5"}) {
    const ScenQuery query = parse("version 1\n" + line + "\n").queries.at(0);
    EXPECT_EQ(query.bucket, 3) << line;
    EXPECT_EQ(query.map, "x.map") << line;
    EXPECT_EQ(query.height, 9) << line;
    EXPECT_EQ(query.goal, (Cell{3, 4})) << line;
    EXPECT_EQ(query.optimum, 12.5) << line;
  }
}

TEST(MovingAiScen, BetweenTabsAMapNameMayHoldSpaces) {
  const ScenQuery query = parse("version 1\n0\tmy own.map\t8\t8\t0\t0\t1\t1\t1.41421\n").queries.at(0);
  EXPECT_EQ(query.map, "my own.map");
}

TEST(MovingAiScen, LinesMayEndInCarriageReturnAndLineFeed) {
  const ScenFile scen = parse("version 1\r\n0\tx.map\t8\t8\t0\t0\t1\t1\t1.41421\r\n");
  ASSERT_EQ(scen.queries.size(), 1U);
  EXPECT_EQ(scen.queries[0].optimum_text, "1.41421");
}

TEST(MovingAiScen, TheLastLineNeedsNoLineEndAndBlankLinesDoNotCount) {
  const std::string two = "version 1\n0 x.map 8 8 0 0 1 0 1\n\n0 x.map 8 8 0 0 2 0 2";
  for (const std::string end : {"", "\n", "\r\n", "\n\n \n\t\n"}) {
    const ScenFile scen = parse(two + end);
    ASSERT_EQ(scen.queries.size(), 2U);
    EXPECT_EQ(scen.queries[0].line, 2);
    EXPECT_EQ(scen.queries[1].line, 4);
  }
}

TEST(MovingAiScen, AQueryMayEndWhereItStarts) {
  const ScenQuery query = parse("version 1\n0 x.map 8 8 5 5 5 5 0\n").queries.at(0);
  EXPECT_EQ(query.start, query.goal);
  EXPECT_TRUE(optimum_matches(query, 0));
  EXPECT_FALSE(optimum_matches(query, 1));
}

TEST(MovingAiScen, AQueryOutsideItsMapIsForTheCallerToCount) {
  const ScenQuery query = parse("version 1\n0 x.map 8 8 -1 0 800 9 3\n").queries.at(0);
  EXPECT_EQ(query.start, (Cell{-1, 0}));
  EXPECT_EQ(query.goal, (Cell{800, 9}));
}

TEST(MovingAiScen, TheMapFieldMayNameAFolderThatIsElsewhere) {
  for (const std::string field : {"x.map", "maps/dao/x.map", "/opt/x.map", "maps\\dao\\x.map"}) {
    const ScenFile scen = parse("version 1\n0\t" + field + "\t8\t8\t0\t0\t1\t0\t1\n");
    EXPECT_EQ(scen.queries[0].map, field);
    EXPECT_NO_THROW(require_same_map(scen, "some/where/x.map")) << field;
  }
}

TEST(MovingAiScen, AQueryOnAnotherMapIsNamedWithItsLine) {
  const ScenFile scen = parse("version 1\n0 a/x.map 8 8 0 0 1 0 1\n0 a/y.map 8 8 0 0 1 0 1\n");
  EXPECT_EQ(message_of<InputError>([&] { require_same_map(scen, "b/x.map"); }),
            "x.scen:3: names map 'a/y.map', expected 'x.map'");
  EXPECT_EQ(message_of<InputError>([&] { require_same_map(scen, "b/y.map"); }),
            "x.scen:2: names map 'a/x.map', expected 'y.map'");
}

// The tolerances below follow from max(0.0051 if two decimals, 1e-6 length + 0.6 unit of the sixth
// significant digit, 1e-6), worked out by hand.

TEST(MovingAiScen, TwoDecimalsLeaveHalfAHundredthOpen) {
  EXPECT_DOUBLE_EQ(optimum_tolerance(query_with_optimum("244.95"), 244.95), 0.0051);
  EXPECT_TRUE(optimum_matches(query_with_optimum("244.95"), 244.945));
  EXPECT_TRUE(optimum_matches(query_with_optimum("244.95"), 244.955));
  EXPECT_FALSE(optimum_matches(query_with_optimum("244.95"), 244.956));
  EXPECT_FALSE(optimum_matches(query_with_optimum("244.95"), 244.944));
}

TEST(MovingAiScen, SixSignificantDigitsLeaveTheSixthOpen) {
  // 106.225: the sixth digit is worth 0.001, so 0.0006 + 0.000106225.
  EXPECT_NEAR(optimum_tolerance(query_with_optimum("106.225"), 106.225), 0.000706225, 1e-12);
  // 1.41421: the sixth digit is worth 0.00001, so 0.000006 + 0.00000141421.
  EXPECT_NEAR(optimum_tolerance(query_with_optimum("1.41421"), 1.41421), 0.00000741421, 1e-12);
  // 1234.56 reads like two decimals: the sixth digit is worth 0.01, so 0.006 + 0.00123456.
  EXPECT_NEAR(optimum_tolerance(query_with_optimum("1234.56"), 1234.56), 0.00723456, 1e-12);
  EXPECT_TRUE(optimum_matches(query_with_optimum("1.41421"), std::sqrt(2.0)));
  EXPECT_TRUE(optimum_matches(query_with_optimum("106.225"), 106.2254));
  EXPECT_FALSE(optimum_matches(query_with_optimum("106.225"), 106.226));
}

TEST(MovingAiScen, AnOptimumPrintedShortIsStillGivenToSixDigits) {
  // 4 is 4.00000.
  EXPECT_NEAR(optimum_tolerance(query_with_optimum("4"), 4), 0.00001, 1e-12);
  EXPECT_TRUE(optimum_matches(query_with_optimum("4"), 4));
  EXPECT_FALSE(optimum_matches(query_with_optimum("4"), 4.0001));
  EXPECT_FALSE(optimum_matches(query_with_optimum("4.5"), 4.505));
}

TEST(MovingAiScen, EightDecimalsFromARoundedRootOfTwoAreMet) {
  // 49 straight and 78 diagonal steps: 159.30865787, or 159.30865784 when sqrt 2 is taken as 1.414213562.
  const ScenQuery query = query_with_optimum("159.30865784");
  EXPECT_TRUE(optimum_matches(query, 49 + 78 * std::sqrt(2.0)));
  EXPECT_FALSE(optimum_matches(query, 51 + 78 * std::sqrt(2.0)));
  EXPECT_FALSE(optimum_matches(query, 49 + 78 * std::sqrt(2.0) + 0.001));
}

TEST(MovingAiScen, AnOptimumOfZeroIsMetToAMillionth) {
  EXPECT_DOUBLE_EQ(optimum_tolerance(query_with_optimum("0"), 0), 1e-6);
  EXPECT_DOUBLE_EQ(optimum_tolerance(query_with_optimum("0.00"), 0), 0.0051);
}

TEST(MovingAiScen, ALengthThatIsNotFiniteMeetsNoOptimum) {
  const ScenQuery query = query_with_optimum("4");
  EXPECT_FALSE(optimum_matches(query, std::numeric_limits<double>::infinity()));
  EXPECT_FALSE(optimum_matches(query, std::numeric_limits<double>::quiet_NaN()));
}

}  // namespace
}  // namespace pathrace::scenarios
