#include "algorithms/ga/breeder.hpp"

#include <algorithm>
#include <optional>
#include <span>

#include "algorithms/ga/fitness.hpp"

namespace pathrace::algorithms {
namespace {

std::size_t most_initial_genes(const Xie2010Settings& settings, std::size_t capacity) {
  const auto wanted = static_cast<std::size_t>(settings.initial_genes);
  return wanted == 0 ? capacity - 2 : std::min(wanted, capacity - 2);
}

}  // namespace

Breeder::Breeder(const Xie2010Settings& settings, const GeneMap& map, std::size_t capacity)
    : settings_(settings),
      map_(map),
      places_(map.size()),
      path_(places_),
      crossover_(places_, settings.crossover),
      inserter_(map, settings.insertion, settings.repair, static_cast<std::size_t>(settings.reach)),
      random_(map, most_initial_genes(settings, capacity)) {
  crossover_.reserve(capacity);
  genes_.reserve(2 * capacity);
}

void Breeder::create(Population& population, std::size_t i, const Stream& stream, const SlotLimit& limit) {
  Stream own = stream.fork(i);
  population[i] = {};
  random_.draw(own, genes_);
  if (settings_.first_generation == FirstGeneration::raw) return judge_raw(population, i);
  rear(population, population.size(), population, i, own, limit);
}

void Breeder::mate(const Population& parents, std::size_t elite, Population& children, std::size_t i,
                   std::size_t count, const Stream& stream, const SlotLimit& limit) {
  Stream own = stream.fork(i);
  const std::span<const Gene> first = parents.genes(tournament(parents, own));
  const std::span<const Gene> second = parents.genes(tournament(parents, own));
  std::optional<Cut> cut;
  if (own.chance(settings_.crossover_rate)) cut = crossover_.cut(first, second, own);
  const Cut at = cut.value_or(Cut{first.size() - 1, second.size() - 1});
  const auto child = [&](std::size_t slot, std::span<const Gene> head, std::span<const Gene> tail,
                         Stream& draws) {
    children[slot] = {};
    join(head, tail);
    if (draws.chance(settings_.mutation_rate)) mutate(map_, settings_.mutation, draws, genes_);
    rear(parents, elite, children, slot, draws, limit);
  };
  const auto tail_of = [&](std::span<const Gene> own_tail, std::span<const Gene> other_tail) {
    return cut ? other_tail : own_tail;
  };
  const std::span<const Gene> first_tail = first.subspan(at.first + 1);
  const std::span<const Gene> second_tail = second.subspan(at.second + 1);
  child(i, first.first(at.first + 1), tail_of(first_tail, second_tail), own);
  if (i + 1 >= count) return;
  Stream sibling = stream.fork(i + 1);
  child(i + 1, second.first(at.second + 1), tail_of(second_tail, first_tail), sibling);
}

// The fittest of a few drawn with replacement; the first drawn of equals.
std::size_t Breeder::tournament(const Population& parents, Stream& stream) const {
  auto best = static_cast<std::size_t>(stream.below(parents.size()));
  for (int k = 1; k < settings_.tournament; ++k) {
    const auto rival = static_cast<std::size_t>(stream.below(parents.size()));
    if (fitter(parents[rival], parents[best])) best = rival;
  }
  return best;
}

void Breeder::join(std::span<const Gene> head, std::span<const Gene> tail) {
  genes_.assign(head.begin(), head.end());
  genes_.insert(genes_.end(), tail.begin(), tail.end());
}

// Fills slot `i` from the genes at work, or from what takes their place.
void Breeder::rear(const Population& parents, std::size_t elite, Population& children, std::size_t i,
                   Stream& stream, const SlotLimit& limit) {
  Individual& individual = children[i];
  for (int failures = 0;; ++failures) {
    if (grow(children, i, stream, limit) || individual.cut) return;
    ++individual.deleted;
    if (failures == settings_.refills) break;
    if (individual.evaluations == limit.evaluations || limit.meter.out_of_time()) {
      individual.cut = true;
      return;
    }
    ++individual.evaluations;
    random_.draw(stream, genes_);
  }
  if (elite < parents.size() && parents[elite].feasible) {
    Individual copy = parents[elite];
    copy.evaluations = individual.evaluations;
    copy.checks = individual.checks;
    copy.deleted = individual.deleted;
    copy.detours = individual.detours;
    return children.copy(i, copy, parents.genes(elite));
  }
  genes_.assign({map_.start(), map_.goal()});
  judge_raw(children, i);
}

bool Breeder::grow(Population& population, std::size_t i, Stream& stream, const SlotLimit& limit) {
  Individual& individual = population[i];
  path_.open(population.slot(i));
  const Inserter::Outcome outcome =
      inserter_.fill(genes_, limit.checks - individual.checks, limit.meter, stream, path_);
  individual.checks += inserter_.checks();
  individual.detours += static_cast<std::uint32_t>(inserter_.detours());
  individual.cut = outcome == Inserter::Outcome::cut;
  if (outcome != Inserter::Outcome::filled) return false;
  individual.size = static_cast<std::uint32_t>(path_.size());
  individual.feasible = true;
  individual.length = step_counts(path_.genes(), map_.stride());
  individual.fitness = fitness(path_.size(), individual.length.value());
  return true;
}

// The genes at work as they are; by chance they are a path already. One check per gene up to the first gap.
void Breeder::judge_raw(Population& population, std::size_t i) const {
  Individual& individual = population[i];
  std::size_t linked = 1;
  while (linked < genes_.size() && map_.linked(genes_[linked - 1], genes_[linked])) ++linked;
  individual.checks += linked;
  individual.feasible = linked == genes_.size();
  std::copy(genes_.begin(), genes_.end(), population.slot(i).begin());
  individual.size = static_cast<std::uint32_t>(genes_.size());
  individual.fitness = fitness(genes_.size(), straight_distances(map_, genes_));
  if (individual.feasible) individual.length = step_counts(genes_, map_.stride());
}

}  // namespace pathrace::algorithms
