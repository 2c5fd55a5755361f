// The mutation operator.
//
//   replace  one random inner gene becomes a random free cell, as published
//   stretch  the genes between two random ones go, and with an even chance a random free cell from nearby
//            stands for them, so that insertion draws that stretch of the path anew (ours: on a path without
//            gaps, `replace` asks for a way to a far cell and back, which is hardly ever shorter)
//
// Xie, Yu, 2010, section 2.4.
#pragma once

#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include "algorithms/ga/gene_map.hpp"
#include "core/names.hpp"
#include "core/stream.hpp"

namespace pathrace::algorithms {

enum class Mutation { replace, stretch };

/// Start and goal stay; a chromosome without inner genes is left alone, and so is one on a map without free
/// cells besides start and goal.
void mutate(const GeneMap& map, Mutation kind, Stream& stream, std::vector<Gene>& genes);

}  // namespace pathrace::algorithms

namespace pathrace {
template <>
inline constexpr auto names_of<algorithms::Mutation> =
    std::to_array<std::pair<algorithms::Mutation, std::string_view>>({
        {algorithms::Mutation::replace, "replace"},
        {algorithms::Mutation::stretch, "stretch"},
    });
}  // namespace pathrace
