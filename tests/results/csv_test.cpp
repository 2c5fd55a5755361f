#include "results/csv.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "results/trace_csv.hpp"

namespace pathrace::results {
namespace {

TEST(Csv, QuotesOnlyWhatNeedsIt) {
  EXPECT_EQ(csv_field("astar"), "astar");
  EXPECT_EQ(csv_field(""), "");
  EXPECT_EQ(csv_field("as:ants=20,alpha=1"), "\"as:ants=20,alpha=1\"");
  EXPECT_EQ(csv_field("the \"best\""), "\"the \"\"best\"\"\"");
  EXPECT_EQ(csv_field("two\nlines"), "\"two\nlines\"");
  EXPECT_EQ(csv_field("\r"), "\"\r\"");
}

TEST(Csv, TextThatASpreadsheetWouldRunIsMarkedAsText) {
  EXPECT_EQ(csv_field("=cmd|'/C calc'!A0"), "'=cmd|'/C calc'!A0");
  EXPECT_EQ(csv_field("=HYPERLINK(\"x\",1)"), "\"'=HYPERLINK(\"\"x\"\",1)\"");
  EXPECT_EQ(csv_field("+1+1"), "'+1+1");
  EXPECT_EQ(csv_field("-1+1"), "'-1+1");
  EXPECT_EQ(csv_field("@SUM(A1)"), "'@SUM(A1)");
  EXPECT_EQ(csv_field("\t=1"), "'\t=1");
  EXPECT_EQ(csv_field("\r=1"), "\"'\r=1\"");
}

TEST(Csv, NumbersStayNumbers) {
  for (const char* number : {"-1", "-0.5", "-1e-300", "-inf", "-1e999", "0", "1e+20"}) {
    EXPECT_EQ(csv_field(number), number);
  }
  EXPECT_EQ(csv_field("-"), "-");
  EXPECT_EQ(csv_field("a=b"), "a=b");
}

TEST(Csv, SeparatesFieldsByCommas) {
  std::ostringstream out;
  write_csv_line(out, {"a", "", "b,c"});
  write_csv_line(out, {"single"});
  EXPECT_EQ(out.str(), "a,,\"b,c\"\nsingle\n");
}

TEST(TraceCsv, HasALinePerImprovement) {
  std::ostringstream out;
  write_trace_csv(out, {{{10, 1, 300}, 0.125, 30}, {{25, 2, 700}, 0.25, 28.5}});
  EXPECT_EQ(out.str(),
            "evaluations,iterations,checks,wall_s,length\n"
            "10,1,300,0.125,30\n"
            "25,2,700,0.25,28.5\n");
}

}  // namespace
}  // namespace pathrace::results
