#include "bench/scen_bench.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <memory>
#include <numeric>

#include "bench/executors.hpp"
#include "bench/reference.hpp"
#include "core/error.hpp"
#include "core/gap.hpp"
#include "core/record.hpp"
#include "core/referee.hpp"
#include "results/median.hpp"
#include "scenarios/library.hpp"
#include "scenarios/movingai/folder.hpp"
#include "scenarios/recorded.hpp"

namespace pathrace::bench {
namespace {

using Clock = std::chrono::steady_clock;

double microseconds_since(Clock::time_point begin) {
  return std::chrono::duration<double, std::micro>(Clock::now() - begin).count();
}

// A planner bound to one of the map's grids (ground or water), with that grid's referee.
struct Bound {
  Terrain terrain;
  std::unique_ptr<MapPlanner> planner;
  Referee referee;
};

class ScenBench {
 public:
  ScenBench(const scenarios::MapFile& map, const scenarios::ScenFile& scen, const Entrant& entrant,
            int repeat)
      : map_(map), scen_(scen), entrant_(entrant), repeat_(repeat), executor_(make_executor("serial", 1)) {}

  ScenReport run(std::size_t limit) {
    for (const std::size_t index : scenarios::spread(scen_.queries.size(), limit))
      query(scen_.queries[index]);
    if (!times_us_.empty()) {
      report_.us_per_query_mean =
          std::accumulate(times_us_.begin(), times_us_.end(), 0.0) / static_cast<double>(times_us_.size());
      report_.us_per_query_median = results::median(times_us_);
    }
    if (planning_us_ > 0)
      report_.expansions_per_second = static_cast<double>(report_.expansions) / planning_us_ * 1e6;
    return std::move(report_);
  }

 private:
  void query(const scenarios::ScenQuery& query) {
    ++report_.queries;
    Scenario scenario;
    try {
      scenario =
          scenarios::scenario_of(fmt::format("{}:{}", scen_.file.string(), query.line), map_, scen_, query);
    } catch (const InvalidScenario& fault) {
      ++report_.bad_queries;
      report_.remarks.push_back(fmt::format("bad query: {}", fault.what()));
      return;
    }
    Bound& bound = bind(scenario.terrain);
    judge(query, scenario, bound, measure(scenario, bound));
  }

  Bound& bind(const Terrain& terrain) {
    auto found = bound_.find(terrain.grid.get());
    if (found != bound_.end()) return *found->second;
    auto bound = std::make_unique<Bound>(Bound{terrain, nullptr, Referee(terrain)});
    const Clock::time_point begin = Clock::now();
    bound->planner = entrant_.card->make(entrant_.values)(bound->terrain);
    report_.setup_us += microseconds_since(begin);
    return *bound_.emplace(terrain.grid.get(), std::move(bound)).first->second;
  }

  Answer measure(const Scenario& scenario, Bound& bound) {
    Answer answer;
    std::vector<double> repeated;
    for (int i = 0; i < repeat_; ++i) {
      Meter meter(entrant_.card->default_budget);
      Context context{root_stream(1, scenario.id, 0), *executor_, meter};
      const Clock::time_point begin = Clock::now();
      answer = bound.planner->plan(scenario.start, scenario.goal, context);
      repeated.push_back(microseconds_since(begin));
      planning_us_ += repeated.back();
      report_.expansions += meter.work().checks;
    }
    times_us_.push_back(results::median(repeated));
    return answer;
  }

  void judge(const scenarios::ScenQuery& query, Scenario& scenario, const Bound& bound,
             const Answer& answer) {
    const bool unknown = query.optimum == 0 && query.start != query.goal;
    if (!answer) return judge_no_answer(query, scenario, unknown);
    const Judgement judgement = bound.referee.judge(*answer, scenario.start, scenario.goal);
    if (!judgement.legal()) return mismatch(scenario, "illegal path: " + judgement.fault);
    if (unknown || answer->track == Track::any_angle) {
      judge_by_proof(query, scenario, bound, *judgement.metrics, answer->track);
    } else {
      judge_by_file(query, scenario, judgement.metrics->length);
    }
  }

  // Right where no way exists, and the file does not say that one does.
  void judge_no_answer(const scenarios::ScenQuery& query, Scenario& scenario, bool unknown) {
    scenarios::prove(scenario);
    if (unknown) ++report_.proven_here;
    if (scenario.optimum.length) {
      mismatch(scenario, fmt::format("no path; the optimum is {}",
                                     unknown ? fmt::format("{}", scenario.optimum.length->value())
                                             : query.optimum_text));
    } else if (unknown) {
      ++report_.matched;
    } else {
      bad(scenario, fmt::format("no way exists, and the optimum is said to be {}", query.optimum_text));
    }
  }

  void judge_by_proof(const scenarios::ScenQuery& query, Scenario& scenario, const Bound& bound,
                      const PathMetrics& metrics, Track track) {
    prove_reference(scenario, track, bound.referee);
    const double proven = reference_length(scenario, track).value_or(0);
    if (query.optimum > 0 && query.optimum < proven && !scenarios::optimum_matches(query, proven)) {
      return bad(scenario, fmt::format("the optimum {} is shorter than the proven any-angle one, {}",
                                       query.optimum_text, proven));
    }
    ++report_.proven_here;
    const std::string fault = contradiction(metrics, scenario, track);
    if (!fault.empty()) return mismatch(scenario, fault);
    if (gap(metrics, scenario, track) == 0) {
      ++report_.matched;
      return;
    }
    const bool beyond_file = query.optimum > 0 && metrics.length > query.optimum &&
                             !scenarios::optimum_matches(query, metrics.length);
    mismatch(scenario, fmt::format("length {}, the proven optimum is {}{}", metrics.length, proven,
                                   beyond_file ? ", the recorded one " + query.optimum_text : ""));
  }

  void judge_by_file(const scenarios::ScenQuery& query, const Scenario& scenario, double length) {
    if (scenarios::optimum_matches(query, length)) {
      ++report_.matched;
    } else if (length < query.optimum) {
      bad(scenario,
          fmt::format("a legal path of {} is shorter than the optimum {}", length, query.optimum_text));
    } else {
      mismatch(scenario, fmt::format("length {}, the optimum is {}", length, query.optimum_text));
    }
  }

  void mismatch(const Scenario& scenario, const std::string& why) {
    ++report_.mismatched;
    report_.remarks.push_back(fmt::format("mismatch: {}: {}", scenario.id, why));
  }

  void bad(const Scenario& scenario, const std::string& why) {
    ++report_.bad_queries;
    report_.remarks.push_back(fmt::format("bad query: {}: {}", scenario.id, why));
  }

  const scenarios::MapFile& map_;
  const scenarios::ScenFile& scen_;
  const Entrant& entrant_;
  int repeat_;
  std::unique_ptr<Executor> executor_;
  std::map<const OccupancyGrid*, std::unique_ptr<Bound>> bound_;
  std::vector<double> times_us_;
  double planning_us_ = 0;
  ScenReport report_;
};

}  // namespace

ScenReport bench_scen(const scenarios::MapFile& map, const scenarios::ScenFile& scen, const Entrant& entrant,
                      std::size_t limit, int repeat) {
  return ScenBench(map, scen, entrant, repeat).run(limit);
}

}  // namespace pathrace::bench
