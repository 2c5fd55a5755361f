// The floor of dynamic worlds: drive straight at the goal, through whatever is in the way.
//
// Without discs it is the shortest run to a goal that stands still. One step is one evaluation.
#include "baselines/navigators/room.hpp"
#include "core/catalogue.hpp"

namespace pathrace::baselines {
namespace {

struct StraightSettings {};

class Straight final : public Navigator {
 public:
  Point next(const Snapshot& snapshot, Context& context) override {
    context.meter.spend_evaluations(1);
    return towards(snapshot.robot, snapshot.goal, snapshot.robot_step);
  }
};

}  // namespace

PlannerCard straight_card() {
  PlannerCard card;
  card.name = "straight";
  card.kind = Kind::floor;
  card.random = false;
  card.summary = "drives straight at the goal and heeds no disc";
  card.source = "floor baseline of this project";
  return with_navigator_parameters(std::move(card), Schema<StraightSettings>{{}},
                                   [](const StraightSettings&) { return std::make_unique<Straight>(); });
}

}  // namespace pathrace::baselines
