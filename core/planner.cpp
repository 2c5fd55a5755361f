#include "core/planner.hpp"

#include <utility>

namespace pathrace {
namespace {

class Unprepared final : public MapPlanner {
 public:
  Unprepared(PlanFunction plan, const Terrain& terrain) : plan_(std::move(plan)), terrain_(terrain) {}

  Answer plan(Cell start, Cell goal, Context& context) override {
    return plan_({*terrain_.grid, terrain_.rule, start, goal}, context);
  }

 private:
  PlanFunction plan_;
  Terrain terrain_;
};

}  // namespace

Planner unprepared(PlanFunction plan) {
  return [plan = std::move(plan)](const Terrain& terrain) -> std::unique_ptr<MapPlanner> {
    return std::make_unique<Unprepared>(plan, terrain);
  };
}

}  // namespace pathrace
