#include "core/parameters.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>

#include "core/move_rule.hpp"
#include "core/stream.hpp"

namespace pathrace {
namespace {

struct Settings {
  int ants = 50;
  std::uint64_t cycles = 7;
  double alpha = 1.5;
  bool both_ways = true;
  MoveRule rule = MoveRule::squeeze;
};

Schema<Settings> schema() {
  return {{
      integer("ants", &Settings::ants, 1, 100000, "ants", Source::field, "ants per iteration"),
      integer("cycles", &Settings::cycles, 0, 10, "", Source::ours, "cycles"),
      real("alpha", &Settings::alpha, -2, 2.5, "", Source::paper, "weight of pheromone"),
      boolean("both_ways", &Settings::both_ways, Source::seen, "deposit in both directions"),
      choice("rule", &Settings::rule, Source::inferred, "how it moves"),
  }};
}

std::string refusal(const std::function<void()>& act) {
  try {
    act();
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

std::string refusal(const std::string& name, const std::string& value) {
  return refusal([&] { schema().settings({{name, value}}); });
}

TEST(Schema, DefaultsComeFromTheStruct) {
  const Settings settings = schema().settings({});
  EXPECT_EQ(settings.ants, 50);
  EXPECT_EQ(settings.alpha, 1.5);
  EXPECT_TRUE(settings.both_ways);
  EXPECT_EQ(settings.rule, MoveRule::squeeze);
}

TEST(Schema, CardsSayAllThatTheCatalogueShows) {
  const std::vector<ParameterCard> cards = schema().cards();
  ASSERT_EQ(cards.size(), 5U);
  EXPECT_EQ(cards[0].name, "ants");
  EXPECT_EQ(cards[0].type, "integer");
  EXPECT_EQ(cards[0].default_value, "50");
  EXPECT_EQ(cards[0].range, "1..100000");
  EXPECT_EQ(cards[0].unit, "ants");
  EXPECT_EQ(cards[0].source, Source::field);
  EXPECT_EQ(cards[0].meaning, "ants per iteration");
  EXPECT_EQ(cards[2].type, "real");
  EXPECT_EQ(cards[2].default_value, "1.5");
  EXPECT_EQ(cards[2].range, "[-2, 2.5]");
  EXPECT_EQ(cards[3].type, "boolean");
  EXPECT_EQ(cards[3].default_value, "true");
  EXPECT_EQ(cards[3].range, "true|false");
  EXPECT_EQ(cards[4].type, "choice");
  EXPECT_EQ(cards[4].default_value, "squeeze");
  EXPECT_EQ(cards[4].range, "four|strict|squeeze|free");
}

TEST(Schema, GivenValuesReplaceDefaultsAndNothingElse) {
  const Settings settings = schema().settings({{"ants", "20"}, {"rule", "free"}, {"both_ways", "false"}});
  EXPECT_EQ(settings.ants, 20);
  EXPECT_EQ(settings.rule, MoveRule::free);
  EXPECT_FALSE(settings.both_ways);
  EXPECT_EQ(settings.alpha, 1.5);
  EXPECT_EQ(settings.cycles, 7U);
}

TEST(Schema, PrintsEveryFieldInCanonicalSpelling) {
  const ParameterValues printed = schema().print(schema().settings({{"alpha", "0.500"}, {"ants", "007"}}));
  EXPECT_EQ(
      printed,
      (ParameterValues{
          {"ants", "7"}, {"cycles", "7"}, {"alpha", "0.5"}, {"both_ways", "true"}, {"rule", "squeeze"}}));
}

TEST(Schema, ReadsBackWhatItPrints) {
  Settings settings;
  settings.ants = 99999;
  settings.cycles = 0;
  settings.alpha = 0.1 + 0.2;
  settings.both_ways = false;
  settings.rule = MoveRule::four;
  const ParameterValues printed = schema().print(settings);
  EXPECT_EQ(schema().settings(printed).alpha, 0.1 + 0.2);
  EXPECT_EQ(schema().print(schema().settings(printed)), printed);
}

TEST(Schema, AnUnknownNameNamesTheNearestMatch) {
  EXPECT_EQ(refusal("alfa", "1"), "unknown parameter 'alfa'; the nearest match is 'alpha'");
  EXPECT_EQ(refusal("Ants", "1"), "unknown parameter 'Ants'; the nearest match is 'ants'");
  EXPECT_EQ(refusal("", "1"), "unknown parameter ''; the nearest match is 'ants'");
  EXPECT_EQ(refusal([] { require_known({{"ants", "1"}}, {}); }), "unknown parameter 'ants'; there are none");
}

TEST(Schema, AnIntegerIsAWholeNumberInItsRange) {
  for (const std::string bad : {"0", "100001", "-1", "", " 5", "5 ", "+5", "5.0", "1e3", "0x10", "five",
                                "99999999999999999999", "nan"}) {
    EXPECT_EQ(refusal("ants", bad), "'ants' must be an integer in 1..100000, got '" + bad + "'");
  }
  EXPECT_EQ(schema().settings({{"ants", "1"}}).ants, 1);
  EXPECT_EQ(schema().settings({{"ants", "100000"}}).ants, 100000);
}

TEST(Schema, ARealIsAFiniteNumberInItsRange) {
  for (const std::string bad : {"2.6", "-2.1", "", " 1", "1 ", "+1", "1,5", "nan", "-nan", "inf", "-inf",
                                "1e400", "-1e400", "1e", "0x1p0", "one"}) {
    EXPECT_EQ(refusal("alpha", bad), "'alpha' must be a number in [-2, 2.5], got '" + bad + "'");
  }
  EXPECT_EQ(schema().settings({{"alpha", "2.5"}}).alpha, 2.5);
  EXPECT_EQ(schema().settings({{"alpha", "-2"}}).alpha, -2.0);
  EXPECT_EQ(schema().settings({{"alpha", "25e-1"}}).alpha, 2.5);
}

Schema<Settings> schema_with_conditions() {
  return {{
              integer("ants", &Settings::ants, 1, 100000, "ants", Source::field, "ants per iteration"),
              real("alpha", &Settings::alpha, -2, 2.5, "", Source::paper, "weight of pheromone"),
              boolean("both_ways", &Settings::both_ways, Source::seen, "deposit in both directions"),
          },
          {{{{"both_ways", "alpha"}, "both_ways needs a positive alpha"},
            [](const Settings& settings) { return !settings.both_ways || settings.alpha > 0; }}}};
}

TEST(Schema, RefusesValuesThatContradictEachOtherAndNamesThem) {
  const Schema<Settings> schema = schema_with_conditions();
  EXPECT_EQ(refusal([&] {
              schema.settings({{"alpha", "-1"}, {"both_ways", "true"}});
            }),
            "both_ways=true and alpha=-1 contradict each other: both_ways needs a positive alpha");
  EXPECT_EQ(refusal([&] {
              schema.settings({{"alpha", "0.0"}});
            }),
            "both_ways=true and alpha=0 contradict each other: both_ways needs a positive alpha");
  EXPECT_EQ(schema.settings({{"alpha", "-1"}, {"both_ways", "false"}}).alpha, -1);
}

TEST(Schema, ShowsItsConditions) {
  ASSERT_EQ(schema_with_conditions().conditions().size(), 1U);
  EXPECT_EQ(schema_with_conditions().conditions()[0].rule, "both_ways needs a positive alpha");
  EXPECT_EQ(schema_with_conditions().conditions()[0].parameters,
            (std::vector<std::string>{"both_ways", "alpha"}));
  EXPECT_TRUE(schema().conditions().empty());
}

TEST(Schema, ALeastValueMayEqualTheGreatestButNotExceedIt) {
  struct Span {
    int low = 3;
    int high = 10;
  };
  const Schema<Span> schema{{integer("low", &Span::low, 1, 20, "", Source::ours, "least"),
                             integer("high", &Span::high, 1, 20, "", Source::ours, "greatest")},
                            {at_most("low", &Span::low, "high", &Span::high)}};
  EXPECT_EQ(schema.settings({{"low", "10"}}).low, 10);
  EXPECT_EQ(refusal([&] {
              schema.settings({{"low", "11"}});
            }),
            "low=11 and high=10 contradict each other: low must be at most high");
  EXPECT_EQ(refusal([&] {
              schema.settings({{"high", "2"}});
            }),
            "low=3 and high=2 contradict each other: low must be at most high");
}

TEST(Schema, MinusZeroIsZero) {
  const Settings settings = schema().settings({{"alpha", "-0"}});
  EXPECT_FALSE(std::signbit(settings.alpha));
  EXPECT_EQ(schema().print(settings).at("alpha"), "0");
}

TEST(Schema, ABooleanIsSpelledOut) {
  for (const std::string bad : {"1", "0", "yes", "True", ""}) {
    EXPECT_EQ(refusal("both_ways", bad), "'both_ways' must be true or false, got '" + bad + "'");
  }
}

TEST(Schema, AnUnknownChoiceNamesTheNearestMatch) {
  EXPECT_EQ(refusal("rule", "squeze"), "unknown value of 'rule' 'squeze'; the nearest match is 'squeeze'");
  EXPECT_NE(refusal("rule", ""), "accepted");
}

TEST(Integers, ReachTheEndsOfTheirRange) {
  constexpr std::int64_t low = std::numeric_limits<std::int64_t>::min();
  constexpr std::int64_t high = std::numeric_limits<std::int64_t>::max();
  EXPECT_EQ(parse_integer("n", "9223372036854775807", low, high), high);
  EXPECT_EQ(parse_integer("n", "-9223372036854775808", low, high), low);
  EXPECT_EQ(parse_integer("n", "-0", low, high), 0);
  EXPECT_THROW(parse_integer("n", "9223372036854775808", low, high), InputError);
}

TEST(Reals, ArePrintedInTheShortestWayThatReadsBack) {
  EXPECT_EQ(print_real(1), "1");
  EXPECT_EQ(print_real(0.1), "0.1");
  EXPECT_EQ(print_real(-2.5), "-2.5");
  EXPECT_EQ(print_real(1e300), "1e+300");
}

TEST(Reals, AnyBitsReadBackTheSame) {
  Stream stream(1);
  for (int i = 0; i < 20000; ++i) {
    const double value = std::bit_cast<double>(stream.bits());
    if (!std::isfinite(value)) continue;
    ASSERT_EQ(parse_real("x", print_real(value), -std::numeric_limits<double>::max(),
                         std::numeric_limits<double>::max()),
              value);
  }
}

}  // namespace
}  // namespace pathrace
