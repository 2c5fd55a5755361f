#include "algorithms/aco/colony.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "algorithms/aco/scout.hpp"
#include "core/checkpoint.hpp"
#include "core/prefetch.hpp"

namespace pathrace::algorithms {
namespace {

Trail::Heuristic heuristic(const ColonySettings& settings, const Nest& nest) {
  if (settings.heuristic == AntHeuristic::inv_step) {
    return [](std::size_t, int direction) { return is_diagonal(direction) ? 1 / std::numbers::sqrt2 : 1.0; };
  }
  const Cell goal = nest.cell(nest.goal());
  return [&settings, &nest, goal](std::size_t index, int direction) {
    const Cell cell = nest.cell(nest.moves().step(index, direction));
    if (cell == goal) return settings.goal_attraction;
    const double dx = cell.x - goal.x;
    const double dy = cell.y - goal.y;
    return 1 / std::sqrt(dx * dx + dy * dy);
  };
}

constexpr std::size_t cells_worth_a_draft = 4096;  // a draft is a copy of them all

std::uint64_t max_steps(const ColonySettings& settings, const Nest& nest) {
  if (settings.max_steps > 0) return static_cast<std::uint64_t>(settings.max_steps);
  return 20 * static_cast<std::uint64_t>(nest.free_cells());
}

}  // namespace

void PheromoneRule::begin(Colony& colony) {
  colony.trail().limit(settings_.pheromone_floor, Trail::no_limit);
}

Colony::Colony(PheromoneRule& rule, const Problem& problem)
    : rule_(rule),
      settings_(rule.settings()),
      problem_(problem),
      nest_(problem),
      walks_(static_cast<std::size_t>(settings_.ants)),
      amounts_(walks_.size()) {
  trail_.emplace(nest_.moves(), 1.0, settings_.alpha, settings_.beta, heuristic(settings_, nest_));
  ground_.emplace(ground_on(*trail_));
}

Ground Colony::ground_on(const Trail& trail) const {
  return {nest_,
          trail,
          settings_.dead_end,
          rule_.q0(),
          max_steps(settings_, nest_),
          rule_.keeps_the_dead(),
          rule_.keeps_popped(),
          rule_.counts_turns()};
}

Answer Colony::run(Context& context) {
  Meter& meter = context.meter;
  executor_ = &context.executor;
  if (!lay_trail(meter)) return std::nullopt;
  rule_.begin(*this);
  make_walkers(context.executor);
  try {
    for (std::uint64_t iteration = 0; !meter.exhausted(); ++iteration) iterate(iteration, context);
  } catch (const OutOfTime&) {  // in the middle of an iteration: the best so far stands
  }
  if (context.overlay != nullptr) draw(*context.overlay);
  const Walk last = settings_.answer == AntAnswer::best_so_far ? best_ : strongest_trail();
  if (!last.arrived) return std::nullopt;
  return rule_.finish(nest_, last);
}

void Colony::iterate(std::uint64_t iteration, Context& context) {
  Meter& meter = context.meter;
  const std::size_t walked = walk_all(context, context.stream.fork(iteration));
  const std::optional<Tally> known = early_tally(walked);
  const std::size_t count = charge(walked, known, meter);
  rule_.revise(*this, context, count);
  const Tally counted = known && count == walked ? *known : tally(count);
  const bool improved = keep_best(counted, meter);
  meter.count("arrived", counted.arrived);
  meter.count("pops", counted.pops);
  meter.end_iteration();
  rule_.learn(*this, {iteration, count, counted.shortest, improved});
}

// False when the goal cannot be reached, or the checks did not suffice to find out.
bool Colony::lay_trail(Meter& meter) {
  double initial = settings_.initial_pheromone;
  if (initial == 0) {
    const ScoutReport report = send_scout(nest_, *trail_, meter.checks_left());
    meter.spend_checks(report.decisions);
    if (report.unreachable) meter.conclude();
    if (!report.scout) return false;
    initial = rule_.initial_pheromone(*report.scout);
  }
  trail_->reset(initial);
  return true;
}

// A walker per thread, all on the same ants; or one per group, on its own.
void Colony::make_walkers(const Executor& executor) {
  const std::size_t ants = walks_.size();
  const std::size_t count =
      groups_.empty() ? std::min(ants, static_cast<std::size_t>(executor.threads())) : groups_.size();
  group_size_ = (ants + count - 1) / count;
  const std::size_t lanes = std::min(group_size_, Walker::lanes_for(nest_.size()));
  const bool hand_ants_over = groups_.empty() && Walker::is_far(nest_.size());  // else walks are too short
  walkers_.clear();
  queues_.clear();
  for (std::size_t k = 0; k < count; ++k) {
    queues_.emplace_back().join(queues_.front());
    walkers_.emplace_back(groups_.empty() ? *ground_ : *groups_[k]->ground, lanes);
    if (hand_ants_over) walkers_.back().join(walkers_.front());
  }
  shared_.reset();
  if (executor.threads() > 1) {
    shared_.emplace(nest_, *trail_, ants, static_cast<std::size_t>(executor.threads()));
  }
  deposits_.reset();
  roll_call_.reset();
  if (!groups_.empty() || count == 1 || rule_.deposits_early() == Early::no) return;
  roll_call_.emplace(ants, count);
  if (nest_.size() <= cells_worth_a_draft) deposits_.emplace(rule_, nest_, *trail_, walks_, *roll_call_);
}

void Colony::regroup(const std::vector<Taste>& tastes) {
  while (groups_.size() < tastes.size()) groups_.push_back(std::make_unique<Group>());
  for (std::size_t g = 0; g < tastes.size(); ++g) {
    Group& group = *groups_[g];
    group.trail.emplace(nest_.moves(), 1.0, tastes[g].alpha, tastes[g].beta, heuristic(settings_, nest_));
    group.trail->limit(trail_->lower_limit(), trail_->upper_limit());
    Pace pace;
    for (std::size_t index = 0; index < nest_.size(); ++index) {
      pace.step();
      for (int d = 0; d < direction_count; ++d) {
        if ((nest_.open(index) >> d & 1) != 0) {
          group.trail->set(index, d, trail_->pheromone(index, d));
        } else {
          group.trail->close(index, d);
        }
      }
    }
    if (!group.ground) group.ground.emplace(ground_on(*group.trail));  // the trail stays in its place
  }
}

// The first walker deposits, too. Ants are dealt out in turn, so that they come back nearly in their order.
std::size_t Colony::walk_all(Context& context, const Stream& stream) {
  const std::size_t batch = context.meter.admitted(walks_.size());
  const Outing outing{stream,   context.meter.checks_left(),        context.meter, walks_,
                      ++round_, roll_call_ ? &*roll_call_ : nullptr};
  EarlyDeposits* const early = deposits_ ? &*deposits_ : nullptr;
  if (early != nullptr) early->begin(batch, outing.round);
  const bool splits_paths = roll_call_ && early == nullptr && rule_.imprint().is_deposit();
  const auto walk = [&](std::size_t walker, AntQueue& ants) {
    if (early != nullptr && walker > 0) trail_->fetch_copies();
    walkers_[walker].run(ants, outing, walker == 0 ? early : nullptr);
    if (splits_paths) shared_->prepare({walks_.data(), batch}, *roll_call_, round_, walker);
  };
  if (groups_.empty()) {
    const std::size_t count = walkers_.size();
    for (std::size_t k = 0; k < count; ++k) queues_[k].fill(k, batch, count);
    for_each_index(context.executor, count, 1, [&](std::size_t walker) { walk(walker, queues_[walker]); });
  } else {
    context.executor.run(batch, group_size_, [&](std::size_t begin, std::size_t end) {
      AntQueue ants(begin, end);
      walk(begin / group_size_, ants);
    });
  }
  return batch;
}

// Pays for the walks in ant order. The ant that meets the end of the checks is cut there: its walk and those
// behind it do not count. Returns how many walks do.
std::size_t Colony::charge(std::size_t walked, const std::optional<Tally>& known, Meter& meter) const {
  if (known && known->decisions < meter.checks_left()) {
    meter.spend_checks(known->decisions);
    meter.spend_evaluations(walked);
    return walked;
  }
  for (std::size_t i = 0; i < walked; ++i) {
    const Walk& walk = walks_[i];
    prefetch(walk.directions.data());  // another core wrote it, and learning reads it next
    const std::uint64_t left = meter.checks_left();
    if (walk.decisions > left || (walk.decisions == left && !walk.arrived && left > 0)) {
      meter.spend_checks(left);
      return i;
    }
    meter.spend_checks(walk.decisions);
    meter.spend_evaluations(1);
    if (meter.checks_left() == 0) return i + 1;
  }
  return walked;
}

Tally Colony::tally(std::size_t count) const {
  Tally tally;
  for (std::size_t i = 0; i < count; ++i) tally.add(walks_[i], rule_);
  return tally;
}

std::optional<Tally> Colony::early_tally(std::size_t count) {
  if (!deposits_) return std::nullopt;
  deposits_->conclude();
  if (deposits_->tally().walks != count) return std::nullopt;
  return deposits_->tally();
}

// Records each ant that is better than all before it. True when there was one.
bool Colony::keep_best(const Tally& tally, Meter& meter) {
  if (tally.shortest == nullptr) return false;
  if (best_.arrived && !rule_.better(*tally.shortest, best_)) return false;
  for (std::size_t i = 0; i < tally.walks; ++i) {
    const Walk& walk = walks_[i];
    if (!walk.arrived || (best_.arrived && !rule_.better(walk, best_))) continue;
    best_ = walk;
    meter.improved(walk.length.value());
  }
  return true;
}

// From the start along the strongest pheromone over unvisited cells; has not arrived when that ends
// elsewhere.
Walk Colony::strongest_trail() const {
  Walk walk;
  std::vector<std::uint8_t> visited(nest_.size(), 0);
  std::size_t cell = nest_.start();
  while (cell != nest_.goal()) {
    visited[cell] = 1;
    int strongest = -1;
    for (int d = 0; d < direction_count; ++d) {
      if ((nest_.open(cell) >> d & 1) == 0 || visited[nest_.moves().step(cell, d)] != 0) continue;
      if (strongest < 0 || trail_->pheromone(cell, d) > trail_->pheromone(cell, strongest)) strongest = d;
    }
    if (strongest < 0) return {};
    walk.directions.push_back(static_cast<std::uint8_t>(strongest));
    cell = nest_.moves().step(cell, strongest);
  }
  walk.arrived = true;
  walk.length = length_of(walk.directions);
  return walk;
}

// The field: per cell the strongest pheromone on a step out of it.
void Colony::draw(Overlay& overlay) const {
  const OccupancyGrid& grid = problem_.grid;
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) {
      const std::size_t index = grid.index({x, y});
      double strongest = 0;
      for (int d = 0; d < direction_count; ++d) {
        const bool open = (nest_.open(index) >> d & 1) != 0;
        if (open) strongest = std::max<double>(strongest, trail_->pheromone(index, d));
      }
      overlay.field.push_back(strongest);
    }
  }
  rule_.draw(overlay);
}

Answer stay(const Problem& problem, Meter& meter, Track track) {
  if (meter.exhausted()) return std::nullopt;
  meter.spend_evaluations(1);
  meter.improved(0);
  return Path{track, {centre(problem.start)}};
}

}  // namespace pathrace::algorithms
