// The extremes: every parameter of every planner at either end of its range, or at each of its choices, the
// others at their defaults. A planner answers, or the call is refused; none crashes or runs on and on.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <ctime>

#include "scenarios/library.hpp"
#include "tests/support/trials.hpp"

namespace pathrace::testing {
namespace {

constexpr double most_seconds = 10;  // of processor time, so that a busy machine fails no test

std::vector<std::string> split(const std::string& text, const std::string& separator) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  for (std::size_t end; (end = text.find(separator, begin)) != std::string::npos;) {
    parts.push_back(text.substr(begin, end - begin));
    begin = end + separator.size();
  }
  parts.push_back(text.substr(begin));
  return parts;
}

std::vector<std::string> extremes_of(const ParameterCard& parameter) {
  const std::string& range = parameter.range;
  if (parameter.type == "integer") return split(range, "..");
  if (parameter.type == "real") return split(range.substr(1, range.size() - 2), ", ");
  if (parameter.type == "boolean" || parameter.type == "choice") return split(range, "|");
  return {};
}

// 200 evaluations; a navigator spends them in each of few steps.
Budget budget_of(const PlannerCard& card) {
  Budget budget;
  budget.evaluations = 200;
  budget.checks = 1'000'000;
  if (card.navigates()) budget.iterations = 20;
  return budget;
}

bool is_an_end(Verdict verdict) {
  return verdict == Verdict::solved || verdict == Verdict::no_path || verdict == Verdict::budget ||
         verdict == Verdict::gave_up;
}

// Whether a condition ties the parameter to others, whose defaults may refuse both of its ends.
bool is_bound(const PlannerCard& card, const std::string& parameter) {
  return std::any_of(card.conditions.begin(), card.conditions.end(), [&](const ConditionCard& condition) {
    return std::count(condition.parameters.begin(), condition.parameters.end(), parameter) > 0;
  });
}

class Extremes : public ::testing::TestWithParam<std::string> {
 protected:
  // False when the call was refused.
  static bool answers(const std::string& call, const Scenario& scenario) {
    const PlannerCard& card = bench::roster().find(parse_call(call).name);
    const std::clock_t begin = std::clock();
    try {
      const TrialRecord record = run({call, budget_of(card)}, scenario);
      EXPECT_TRUE(is_an_end(record.verdict)) << call << ": " << name(record.verdict) << ' ' << record.note;
    } catch (const InputError&) {
      return false;
    }
    const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    EXPECT_LT(seconds, most_seconds) << call;
    return true;
  }
};

TEST_P(Extremes, AreAnsweredOrRefused) {
  const PlannerCard& card = bench::roster().find(GetParam());
  const Scenario scenario = scenarios::Library().load(card.navigates() ? "discs/ring/1" : "trap-u/20/1");
  EXPECT_TRUE(answers(card.name, scenario));
  for (const ParameterCard& parameter : card.parameters) {
    std::size_t answered = 0;
    const std::vector<std::string> values = extremes_of(parameter);
    for (const std::string& value : values) {
      answered += answers(fmt::format("{}:{}={}", card.name, parameter.name, value), scenario) ? 1 : 0;
    }
    EXPECT_TRUE(values.empty() || answered > 0 || is_bound(card, parameter.name))
        << card.name << ':' << parameter.name;
  }
}

std::vector<std::string> planners() {
  std::vector<std::string> names;
  for (const PlannerCard& card : bench::roster().cards()) {
    if (!card.parameters.empty()) names.push_back(card.name);
  }
  return names;
}

std::string test_name(const ::testing::TestParamInfo<std::string>& info) {
  std::string text = info.param;
  std::replace_if(
      text.begin(), text.end(), [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
  return text;
}

INSTANTIATE_TEST_SUITE_P(All, Extremes, ::testing::ValuesIn(planners()), test_name);

}  // namespace
}  // namespace pathrace::testing
