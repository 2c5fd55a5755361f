// A reconstruction of the grouped-teaching ant colony.
//
// Ant System with four changes:
//   1. An ant that is stuck steps back, and the cell it leaves becomes an obstacle (1.2.2).
//   2. Only two paths are reinforced: the iteration's best by c Q1 / L, the best so far by c Q2 / L with
//      Q2 = 2 Q1; c counts the iterations for which a path has been the shortest (1.2.3).
//   3. Redundant corners are cut off a path before it is judged (1.2.4).
//   4. Ants teach each other: see teaching (paths) and group_teaching (parameters).
//
// After Pu Xingcheng et al., 2022, of which only page 767 is known. 1 to 3 follow that page; 4 is a guess
// from the title ("grouped teaching" is the name of an optimisation algorithm), so results are this colony's,
// never the paper's. algorithms.md 3.
//
// What is open is settled so: a path that is both the iteration's best and the best so far counts as the
// latter; the iteration's best has c = 1; c of the best so far starts at 1, grows by 1 per iteration and is
// capped. Cells become obstacles at the iteration's end. The default marks dominated cells only, in a layer
// of their own; `dead_table = global_literal` makes obstacles as published, unless that would cut the goal
// off. One lesson is one evaluation; cutting corners costs a check per cell.
#include "algorithms/aco/pu/pu2022.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "algorithms/aco/colony.hpp"
#include "algorithms/aco/dead_ends.hpp"
#include "algorithms/aco/pu/parameter_school.hpp"
#include "algorithms/aco/pu/simplify.hpp"
#include "algorithms/aco/pu/teaching.hpp"
#include "core/error.hpp"

namespace pathrace::algorithms {
namespace {

using S = Pu2022Settings;

Schema<S> schema() {
  return colony_schema<S>(
      {
          choice("dead_table", &S::dead_table, Source::paper,
                 "what becomes of cells that ants stepped back from (dead_end = backtrack): none, per_ant: "
                 "nothing beyond the ant's own list; global_literal: obstacles, as published; "
                 "global_dominated: closed if no shortest way can need them"),
          choice("update", &S::update, Source::paper,
                 "tiers: iteration's best and best so far, by Q1 and Q2; all_ants: as in Ant System"),
          real("global_factor", &S::global_factor, 0, 1000, "", Source::paper, "Q2 / Q1; Q1 is `deposit`"),
          boolean("others", &S::others, Source::inferred,
                  "whether the ants that are neither add Q1 / L, which the printed formula leaves out"),
          integer("c_cap", &S::c_cap, 0, 1'000'000'000, "iterations", Source::inferred,
                  "largest c; 1: no accumulation; 0: none, the literal text, whose deposits grow for ever"),
          boolean("simplify", &S::simplify, Source::paper,
                  "cut redundant corners off, where the move rule allows it"),
          choice(
              "teaching", &S::teaching, Source::inferred,
              "paths: splices between ants; parameters: groups of ants learn alpha, beta, evaporation and Q"),
          boolean("grouping", &S::grouping, Source::inferred,
                  "whether outstanding and average students are taught differently"),
          integer("students", &S::students, 3, 100, "groups", Source::inferred,
                  "teaching = parameters: groups of ants, besides one that tries the mean of the best three"),
      },
      {
          {{{"teaching", "students", "ants"}, "teaching = parameters needs more ants than students"},
           [](const S& settings) {
             return settings.teaching != Teaching::parameters || settings.ants > settings.students;
           }},
      });
}

class Pu2022 : public PheromoneRule {
 public:
  Pu2022(const S& settings, const Problem& problem, const Stream& stream)
      : PheromoneRule(settings),
        settings_(settings),
        dead_ends_(problem, settings.dead_table, DeadCells::Layer::obstacle) {
    if (settings.teaching == Teaching::parameters) school_.emplace(settings, stream);
  }

  double initial_pheromone(const Scout& scout) const override { return settings_.ants / scout.length; }
  bool keeps_popped() const override { return dead_ends_.global(); }

  void begin(Colony& colony) override {
    PheromoneRule::begin(colony);
    cutter_.emplace(colony.nest().moves());
    splicer_.emplace(colony.nest());
    if (school_) school_->begin(colony);
  }

  void revise(Colony& colony, Context& context, std::size_t count) override {
    for (std::size_t k = 0; k < count; ++k) cut_corners(colony.nest(), colony.walks()[k], context.meter);
    if (settings_.teaching == Teaching::paths) teach(colony, context, count);
    ++iteration_;
  }

  void learn(Colony& colony, const Harvest& harvest) override {
    dead_ends_.mark(colony, harvest.count);
    if (school_) school_->judge(colony, harvest);
    colony.trail().evaporate(1 - (school_ ? school_->evaporation() : settings_.evaporation));
    if (settings_.update == PuUpdate::all_ants) {
      colony.deposit_all(harvest.count);
    } else {
      deposit_tiers(colony, harvest);
    }
    if (school_) school_->assign(colony);
  }

  double amount(const Walk& walk) const override {
    return (school_ ? school_->deposit() : settings_.deposit) / walk.length.value();
  }

 private:
  void cut_corners(const Nest& nest, Walk& walk, Meter& meter) {
    const std::size_t cells = walk.directions.size() + 1;
    if (!settings_.simplify || !walk.arrived || meter.checks_left() < cells) return;
    meter.spend_checks(cells);
    if (cutter_->cut(nest.start(), walk.directions)) walk.length = length_of(walk.directions);
  }

  void teach(Colony& colony, Context& context, std::size_t count) {
    std::vector<Walk*> pupils;
    std::vector<LatticeLength> before;
    pupils.reserve(count);
    before.reserve(count);
    for (std::size_t k = 0; k < count; ++k) {
      Walk& walk = colony.walks()[k];
      if (!walk.arrived) continue;
      pupils.push_back(&walk);
      before.push_back(walk.length);
    }
    Meter& meter = context.meter;
    std::uint64_t lessons = 0;
    const auto charge = [&](std::size_t cells) {
      if (meter.admitted(1) == 0 || meter.checks_left() < cells) return false;
      meter.spend_evaluations(1);
      meter.spend_checks(cells);
      ++lessons;
      return true;
    };
    const Stream stream = context.stream.fork(iteration_).fork("teaching");
    teach_paths(pupils, settings_.grouping, *splicer_, stream, charge);
    if (lessons > 0) meter.count("lessons", lessons);
    for (std::size_t i = 0; i < pupils.size(); ++i) {
      if (pupils[i]->length != before[i])
        cut_corners(colony.nest(), *pupils[i], meter);  // the joint may be one
    }
  }

  void deposit_tiers(Colony& colony, const Harvest& harvest) {
    if (settings_.others) deposit_others(colony, harvest);
    if (!colony.best().arrived) return;
    c_ = harvest.improved ? 1 : c_ + 1;
    if (settings_.c_cap > 0) c_ = std::min<double>(c_, settings_.c_cap);
    const Walk& best = colony.best();
    const bool new_path = harvest.shortest != nullptr && harvest.shortest->directions != best.directions;
    if (new_path) colony.deposit(*harvest.shortest, amount(*harvest.shortest));
    colony.deposit(best, c_ * settings_.global_factor * amount(best));
  }

  void deposit_others(Colony& colony, const Harvest& harvest) const {
    for (std::size_t k = 0; k < harvest.count; ++k) {
      const Walk& walk = colony.walks()[k];
      if (!walk.arrived || &walk == harvest.shortest || walk.directions == colony.best().directions) continue;
      colony.deposit(walk, amount(walk));
    }
  }

  const S& settings_;
  DeadEnds dead_ends_;
  std::optional<CornerCutter> cutter_;
  std::optional<Splicer> splicer_;
  std::optional<ParameterSchool> school_;
  std::uint64_t iteration_ = 0;
  double c_ = 0;
};

// The same colony on the lattice; its answer is straightened at the end.
class Pu2022AnyAngle final : public Pu2022 {
 public:
  Pu2022AnyAngle(const S& settings, const Problem& problem, const Stream& stream)
      : Pu2022(settings, problem, stream), grid_(problem.grid) {
    if (problem.rule == MoveRule::free) {
      throw Unsupported(
          "any-angle paths do not pass between blocked cells that touch, as the rule 'free' allows");
    }
  }

  Path finish(const Nest& nest, const Walk& best) const override {
    std::vector<Cell> cells;
    for (const std::uint32_t index : cells_of(nest, best)) cells.push_back(nest.cell(index));
    Path path = lattice_path(straightened(grid_, cells));
    path.track = Track::any_angle;
    return path;
  }

 private:
  const OccupancyGrid& grid_;
};

PlannerCard card_named(std::string name, std::string summary) {
  PlannerCard card;
  card.name = std::move(name);
  card.version = 2;
  card.summary = std::move(summary);
  card.source =
      "after Pu X. et al., 2022, p. 767; the teaching after Zhang, Jin, Expert Syst. Appl. 148, 2020";
  card.default_budget.iterations = 100;
  return card;
}

}  // namespace

PlannerCard pu2022_card() {
  return colony_card<S, Pu2022>(
      card_named("pu2022", "grouped-teaching ant colony, a reconstruction from one page of the paper"),
      schema());
}

PlannerCard pu2022_any_angle_card() {
  PlannerCard card = card_named("pu2022-any-angle", "pu2022 with its answer straightened off the lattice");
  card.track = Track::any_angle;
  return colony_card<S, Pu2022AnyAngle>(std::move(card), schema());
}

}  // namespace pathrace::algorithms
