// A planner of one's own, raced and judged with nothing but the core of the installed package.
//
// The map is 4x2 cells with a wall below the way, so that going straight ahead is both legal and best.
#include <cstdio>
#include <memory>

#include "core/gap.hpp"
#include "core/planner.hpp"
#include "core/record.hpp"
#include "core/referee.hpp"
#include "core/reference/exact_search.hpp"

namespace {

class Inline final : public pathrace::Executor {
 public:
  std::string_view name() const override { return "inline"; }
  int threads() const override { return 1; }

 private:
  void run_chunks(std::size_t count, std::size_t, pathrace::ChunkBody body) override { body(0, count); }
};

pathrace::Answer straight_ahead(const pathrace::Problem& problem, pathrace::Context& context) {
  pathrace::Path path;
  for (int x = problem.start.x; x <= problem.goal.x; ++x) path.points.push_back({1.0 * x, 0.0});
  context.meter.spend_evaluations(1);
  return path;
}

}  // namespace

int main() {
  auto grid = std::make_shared<pathrace::OccupancyGrid>(4, 2);
  grid->block({1, 1});
  const pathrace::Terrain terrain{grid, pathrace::MoveRule::strict};
  const pathrace::Cell start{0, 0};
  const pathrace::Cell goal{3, 0};

  Inline executor;
  pathrace::Meter meter{pathrace::Budget{}};
  pathrace::Context context{pathrace::root_stream(1, "consumer", 0), executor, meter};
  const pathrace::Answer answer = pathrace::unprepared(straight_ahead)(terrain)->plan(start, goal, context);
  const pathrace::Judgement judgement = pathrace::Referee(terrain).judge(*answer, start, goal);
  if (!judgement.legal()) {
    std::fprintf(stderr, "the referee refused the path: %s\n", judgement.fault.c_str());
    return 1;
  }
  const auto gap = pathrace::gap(*judgement.metrics, pathrace::reference::optimum(terrain, start, goal));
  std::printf("length %g, gap %g\n", judgement.metrics->length, gap.value_or(-1));
  return gap == 0.0 ? 0 : 1;
}
