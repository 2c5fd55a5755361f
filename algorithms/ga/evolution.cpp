#include "algorithms/ga/evolution.hpp"

#include <algorithm>
#include <utility>

#include "core/checkpoint.hpp"

namespace pathrace::algorithms {
namespace {

// A loop on threads that are at hand costs about a microsecond, a cell about 5 nanoseconds: chunks that
// handle fewer cells are not worth a thread.
constexpr std::uint64_t least_cells_per_chunk = 500;

std::size_t capacity_on(const GeneMap& map, int population) {
  return std::min(map.inner().size() + 2,
                  Evolution::longest_chromosome(static_cast<std::size_t>(population)));
}

}  // namespace

Evolution::Evolution(const Xie2010Settings& settings, const Problem& problem, Context& context)
    : settings_(settings),
      problem_(problem),
      context_(context),
      map_(problem),
      capacity_(capacity_on(map_, settings.population)),
      parents_(static_cast<std::size_t>(settings.population), capacity_),
      children_(static_cast<std::size_t>(settings.population), capacity_) {}

// Together at most 2^26 genes, 256 MiB, unless individuals are very many.
std::size_t Evolution::longest_chromosome(std::size_t population) {
  constexpr std::size_t total = std::size_t{1} << 26;
  return std::clamp(total / population, std::size_t{1} << 12, std::size_t{1} << 18);
}

Answer Evolution::run() {
  if (context_.meter.exhausted()) return std::nullopt;
  try {
    found();
    for (std::uint64_t generation = 1; !context_.meter.exhausted(); ++generation) {
      breed(generation);
      context_.meter.end_iteration();
    }
  } catch (const OutOfTime&) {  // while a breeder was made ready: the best so far stands
  }
  if (context_.overlay != nullptr) draw(*context_.overlay);
  return answer();
}

void Evolution::found() {
  Meter& meter = context_.meter;
  const std::size_t count = meter.admitted(parents_.size());
  const SlotLimit limit{meter.evaluations_left(), meter.checks_left(), meter};
  const Stream stream = context_.stream.fork(std::uint64_t{0});
  const std::size_t grain = chunk_size(count);
  const auto body = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) breeders_[begin / grain].create(parents_, i, stream, limit);
  };
  context_.executor.run(count, grain, body);
  keep_best(parents_, charge(parents_, count));
}

void Evolution::breed(std::uint64_t generation) {
  Meter& meter = context_.meter;
  const std::size_t count = meter.admitted(children_.size());
  const SlotLimit limit{meter.evaluations_left(), meter.checks_left(), meter};
  const Stream stream = context_.stream.fork(generation);
  const std::size_t elite = parents_.best(parents_.size());
  const std::size_t pairs = (count + 1) / 2;
  const std::size_t grain = chunk_size(pairs);
  const auto body = [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) {
      breeders_[begin / grain].mate(parents_, elite, children_, 2 * p, count, stream, limit);
    }
  };
  context_.executor.run(pairs, grain, body);
  keep_best(children_, charge(children_, count));
  const std::size_t worst = children_.worst(count);
  const bool stays = settings_.elitism && parents_[elite].feasible;
  if (stays && fitter(parents_[elite], children_[worst])) {
    children_.copy(worst, parents_[elite], parents_.genes(elite));
  }
  std::swap(parents_, children_);
}

// How many of so many tasks one chunk takes; sees to it that each chunk has its breeder.
std::size_t Evolution::chunk_size(std::size_t tasks) {
  const auto threads = static_cast<std::size_t>(context_.executor.threads());
  const std::size_t most = threads == 1 ? 1 : 2 * threads;
  const std::size_t worth = static_cast<std::size_t>(work_ / least_cells_per_chunk);
  const std::size_t chunks = std::clamp<std::size_t>(worth, 1, most);
  const std::size_t grain = std::max<std::size_t>(1, (tasks + chunks - 1) / chunks);
  while (breeders_.size() * grain < tasks || breeders_.empty()) {
    checkpoint();
    breeders_.emplace_back(settings_, map_, capacity_);
  }
  return grain;
}

// Pays for the individuals in order. The one that meets the end of the budget is cut there: neither it nor
// those behind it count. Returns how many do.
std::size_t Evolution::charge(const Population& population, std::size_t count) {
  Meter& meter = context_.meter;
  std::uint64_t deleted = 0;
  std::uint64_t detours = 0;
  work_ = 0;
  std::size_t counted = 0;
  for (; counted < count; ++counted) {
    const Individual& individual = population[counted];
    const bool cut = individual.cut || individual.evaluations > meter.evaluations_left() ||
                     individual.checks > meter.checks_left();
    meter.spend_evaluations(std::min(individual.evaluations, meter.evaluations_left()));
    meter.spend_checks(std::min(individual.checks, meter.checks_left()));
    if (cut) break;
    deleted += individual.deleted;
    detours += individual.detours;
    work_ += individual.checks + individual.size;
  }
  meter.count("deleted", deleted);
  meter.count("detours", detours);
  return counted;
}

void Evolution::keep_best(const Population& population, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    const Individual& individual = population[i];
    if (!individual.feasible || (!best_.empty() && individual.length >= shortest_)) continue;
    const std::span<const Gene> genes = population.genes(i);
    best_.assign(genes.begin(), genes.end());
    shortest_ = individual.length;
    context_.meter.improved(shortest_.value());
  }
}

Answer Evolution::answer() const {
  if (best_.empty()) return std::nullopt;
  std::vector<Cell> cells;
  cells.reserve(best_.size());
  for (const Gene gene : best_) cells.push_back(map_.cell(gene));
  return lattice_path(cells);
}

// The field: per cell the share of the last generation that passes through it.
void Evolution::draw(Overlay& overlay) const {
  const auto width = static_cast<std::size_t>(problem_.grid.width());
  overlay.field.assign(width * static_cast<std::size_t>(problem_.grid.height()), 0.0);
  const double share = 1 / static_cast<double>(parents_.size());
  for (std::size_t i = 0; i < parents_.size(); ++i) {
    for (const Gene gene : parents_.genes(i)) {
      const Cell cell = map_.cell(gene);
      overlay.field[static_cast<std::size_t>(cell.y) * width + static_cast<std::size_t>(cell.x)] += share;
    }
  }
}

}  // namespace pathrace::algorithms
