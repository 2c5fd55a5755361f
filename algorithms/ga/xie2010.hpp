// The settings of the genetic algorithm for the AS-R robot.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <utility>

#include "algorithms/ga/crossover.hpp"
#include "algorithms/ga/insertion.hpp"
#include "algorithms/ga/mutation.hpp"
#include "core/names.hpp"

namespace pathrace::algorithms {

enum class FirstGeneration {
  raw,       ///< judged with its gaps, as published
  repaired,  ///< its gaps are filled first
};

struct Xie2010Settings {
  int population = 20;
  double crossover_rate = 0.6;
  double mutation_rate = 0.01;
  int tournament = 2;
  bool elitism = true;
  FirstGeneration first_generation = FirstGeneration::raw;
  int initial_genes = 0;
  CrossoverPoint crossover = CrossoverPoint::common;
  Mutation mutation = Mutation::replace;
  Insertion insertion = Insertion::faithful;
  GapRepair repair = GapRepair::none;
  int reach = 256;
  int refills = 50;
};

}  // namespace pathrace::algorithms

namespace pathrace {
template <>
inline constexpr auto names_of<algorithms::FirstGeneration> =
    std::to_array<std::pair<algorithms::FirstGeneration, std::string_view>>({
        {algorithms::FirstGeneration::raw, "raw"},
        {algorithms::FirstGeneration::repaired, "repaired"},
    });
}  // namespace pathrace
