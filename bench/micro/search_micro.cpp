// Exact and any-angle search: time per query, path extracted, and per expansion, beside a textbook A*.
//
// One pass over a map's queries is one iteration; set-up on the map is not timed. Counters: `query` and
// `expansion`, seconds each; an expansion of jps is a jump point, of any-angle-optimum a corner. Generated
// maps always; with PATHRACE_DATA also the MovingAI maps arena2 and random512-25-5, queries spread over their
// scen files. Move rule `strict`.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "baselines/grid/one_to_all.hpp"
#include "bench/executors.hpp"
#include "bench/micro/textbook_astar.hpp"
#include "bench/roster.hpp"
#include "core/reference/exact_search.hpp"
#include "scenarios/library.hpp"
#include "scenarios/movingai/folder.hpp"
#include "scenarios/recorded.hpp"

namespace pathrace::bench::micro {
namespace {

namespace fs = std::filesystem;

struct Query {
  Cell start;
  Cell goal;
};

struct QuerySet {
  Terrain terrain;
  std::vector<Query> queries;
};

constexpr std::size_t query_count = 40;

QuerySet generated(const std::string& id) {
  QuerySet set{scenarios::Library().load(id).terrain, {}};
  const OccupancyGrid& grid = *set.terrain.grid;
  Stream stream(1);
  const auto draw = [&] {
    return Cell{stream.between(0, grid.width() - 1), stream.between(0, grid.height() - 1)};
  };
  while (set.queries.size() < query_count) {
    const Query query{draw(), draw()};
    if (!grid.is_free(query.start) || !grid.is_free(query.goal)) continue;
    if (reference::optimum(set.terrain, query.start, query.goal).length) set.queries.push_back(query);
  }
  return set;
}

QuerySet recorded(const fs::path& map_file) {
  const scenarios::MapFile map = scenarios::MapFile::read(map_file);
  const scenarios::ScenFile scen = scenarios::ScenFile::read(map_file.string() + ".scen");
  QuerySet set;
  for (const std::size_t index : scenarios::spread(scen.queries.size(), query_count)) {
    const Scenario scenario = scenarios::scenario_of("query", map, scen, scen.queries[index]);
    set.terrain = scenario.terrain;
    set.queries.push_back({scenario.start, scenario.goal});
  }
  return set;
}

void report(benchmark::State& state, std::uint64_t queries, std::uint64_t expansions) {
  const auto each = [](std::uint64_t count) {
    return benchmark::Counter(static_cast<double>(count),
                              benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  };
  state.counters["query"] = each(queries);
  state.counters["expansion"] = each(expansions);
}

void textbook(benchmark::State& state, const QuerySet& set) {
  std::uint64_t queries = 0;
  std::uint64_t expansions = 0;
  for (auto _ : state) {
    for (const Query& query : set.queries) {
      const TextbookAnswer answer = textbook_astar(*set.terrain.grid, query.start, query.goal);
      benchmark::DoNotOptimize(answer.cells.data());
      expansions += answer.expanded;
      ++queries;
    }
  }
  report(state, queries, expansions);
}

void search(benchmark::State& state, const QuerySet& set, const std::string& planner_name) {
  const Entrant entrant = roster().enter({planner_name, {}});
  const std::unique_ptr<MapPlanner> planner = entrant.card->make(entrant.values)(set.terrain);
  const std::unique_ptr<Executor> executor = make_executor("serial", 1);
  std::uint64_t queries = 0;
  std::uint64_t expansions = 0;
  for (auto _ : state) {
    for (const Query& query : set.queries) {
      Meter meter(Budget{});
      Context context{Stream(1), *executor, meter};
      benchmark::DoNotOptimize(planner->plan(query.start, query.goal, context));
      expansions += meter.work().checks;
      ++queries;
    }
  }
  report(state, queries, expansions);
}

void one_to_all(benchmark::State& state, const QuerySet& set) {
  baselines::OneToAll distances(set.terrain);
  std::uint64_t queries = 0;
  for (auto _ : state) {
    distances.measure(set.queries.front().start);
    benchmark::DoNotOptimize(distances.distance(set.queries.front().goal));
    ++queries;
  }
  state.counters["query"] = benchmark::Counter(static_cast<double>(queries),
                                               benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void set_up(benchmark::State& state, const QuerySet& set, const std::string& planner_name) {
  const Entrant entrant = roster().enter({planner_name, {}});
  for (auto _ : state) benchmark::DoNotOptimize(entrant.card->make(entrant.values)(set.terrain));
}

void add(const std::string& map, const std::function<QuerySet()>& make) {
  const auto set =
      std::make_shared<std::unique_ptr<QuerySet>>();  // made when the first of its benchmarks runs
  const auto with_set = [set, make](const auto& run) {
    return [set, make, run](benchmark::State& state) {
      if (!*set) *set = std::make_unique<QuerySet>(make());
      run(state, **set);
    };
  };
  const auto name = [&](const std::string& what) { return "search/" + map + "/" + what; };
  const auto registered = [](const std::string& text, const auto& run) {
    benchmark::RegisterBenchmark(text.c_str(), run)->Unit(benchmark::kMillisecond);
  };
  registered(name("textbook"),
             with_set([](benchmark::State& state, const QuerySet& queries) { textbook(state, queries); }));
  for (const std::string planner :
       {"astar", "jps", "dijkstra", "theta-star", "lazy-theta-star", "any-angle-optimum"}) {
    registered(name(planner), with_set([planner](benchmark::State& state, const QuerySet& queries) {
                 search(state, queries, planner);
               }));
    registered(name(planner + "/set-up"),
               with_set([planner](benchmark::State& state, const QuerySet& queries) {
                 set_up(state, queries, planner);
               }));
  }
  registered(name("one-to-all"),
             with_set([](benchmark::State& state, const QuerySet& queries) { one_to_all(state, queries); }));
}

const bool all_registered = [] {
  for (const char* id : {"random/512-25/1", "caves/512-45/1"}) {
    std::string map = id;
    std::replace(map.begin(), map.end(), '/', '-');
    add(map, [id] { return generated(id); });
  }
  const char* data = std::getenv("PATHRACE_DATA");
  if (data == nullptr || *data == '\0') return true;
  for (const char* map : {"dao/arena2.map", "random512/random512-25-5.map"}) {
    const fs::path file = fs::path(data) / "movingai" / map;
    add(file.stem().string(), [file] { return recorded(file); });
  }
  return true;
}();

}  // namespace
}  // namespace pathrace::bench::micro
