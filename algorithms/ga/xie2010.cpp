// A genetic algorithm for the path of an AS-R robot.
//
// Individuals are rows of cells from start to goal, of any length, with gaps at first (see gene_map,
// random_chromosome). A generation: tournaments choose parents, and then (each in its own file)
//   crossover  two parents change tails
//   mutation   one cell becomes another
//   insertion  gaps are filled with free cells
//   deletion   loops are cut (loop_free_path)
//   fitness    f = (1 + 1 / sqrt(n + 1)) D
//
// Xie Mujun, Yu Guangwei, "Research of AS-R mobile robot path planning based on genetic algorithms",
// Microcomputer & Its Applications 29(4), 2010. algorithms.md 5.
//
// What the paper leaves open ([I] in the files, each a parameter) decides little: on its three maps, with its
// parameters, every reading finds the optimum for at least 97 of 100 seeds (the defaults for 100, 98, 100 on
// fig. 2, 5, 6). Of the lengths that it prints, fig. 5's 312.1 cm is the optimum under strict corners; fig.
// 6's 291.4 cm is the length of no path between these corners (the optimum is 341.4), and the map of fig. 3
// and 4 is not printed.
//
// The published insertion steps right, lower right and down only: `insertion = faithful` solves maps whose
// start is at the upper left and whose goal is at the lower right with no way up or left between, and fails
// by construction on others. `insertion = general` turns the three directions towards the next gene, and
// `repair = local_search` leads out where they are blocked.
#include "algorithms/ga/xie2010.hpp"

#include <utility>

#include "algorithms/ga/evolution.hpp"
#include "core/catalogue.hpp"

namespace pathrace::algorithms {
namespace {

using S = Xie2010Settings;

Schema<S> schema() {
  return {
      {
          integer("population", &S::population, 1, 100000, "individuals", Source::paper,
                  "children per generation as well"),
          real("crossover_rate", &S::crossover_rate, 0, 1, "", Source::paper,
               "Pc, chance per pair of parents"),
          real("mutation_rate", &S::mutation_rate, 0, 1, "", Source::paper, "Pm, chance per child"),
          integer("tournament", &S::tournament, 1, 1000, "individuals", Source::field,
                  "how many are drawn, with replacement, for the fittest to be a parent"),
          boolean("elitism", &S::elitism, Source::paper,
                  "the fittest parent, if it is a path, takes the place of a less fit child"),
          choice("first_generation", &S::first_generation, Source::paper,
                 "raw: judged with its gaps, behind every path; repaired: its gaps are filled first"),
          integer("initial_genes", &S::initial_genes, 0, 1 << 18, "cells", Source::inferred,
                  "most cells between start and goal of a random chromosome; 0: all free cells of the map"),
          choice("crossover", &S::crossover, Source::inferred,
                 "common: cut at a cell that both parents visit, where there is one; free: anywhere"),
          choice("mutation", &S::mutation, Source::paper,
                 "replace: a random cell for one cell; stretch (ours): a random stretch of the path is drawn "
                 "anew"),
          choice("insertion", &S::insertion, Source::paper,
                 "faithful: right, lower right, down, never past the next gene; blind: past it too; general: "
                 "towards the next gene"),
          choice("repair", &S::repair, Source::ours,
                 "where general insertion is blocked: none, the individual is deleted; local_search, the "
                 "nearest way out"),
          integer("reach", &S::reach, 1, 1 << 24, "cells", Source::ours,
                  "most cells that one local search expands"),
          integer("refills", &S::refills, 0, 1'000'000, "individuals", Source::inferred,
                  "fresh random ones tried for a deleted one, before a copy of the fittest takes its place"),
      },
      {
          {{{"repair", "insertion"}, "repair = local_search needs insertion = general"},
           [](const S& settings) {
             return settings.repair == GapRepair::none || settings.insertion == Insertion::general;
           }},
      }};
}

// Start and goal in one cell: a chromosome of one gene.
Answer stay(const Problem& problem, Meter& meter) {
  if (meter.exhausted()) return std::nullopt;
  meter.spend_evaluations(1);
  meter.improved(0);
  return lattice_path({problem.start});
}

Answer plan(const S& settings, const Problem& problem, Context& context) {
  if (problem.start == problem.goal) return stay(problem, context.meter);
  return Evolution(settings, problem, context).run();
}

}  // namespace

PlannerCard xie2010_card() {
  PlannerCard card;
  card.name = "xie2010";
  card.kind = Kind::ga;
  card.summary = "genetic algorithm on rows of cells, with insertion and deletion operators";
  card.source = "Xie M., Yu G., Microcomputer & Its Applications 29(4), 2010";
  card.default_budget.iterations = 10;
  return with_parameters(std::move(card), schema(), [](const S& settings) {
    return unprepared(
        [settings](const Problem& problem, Context& context) { return plan(settings, problem, context); });
  });
}

}  // namespace pathrace::algorithms
