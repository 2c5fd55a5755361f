// The folder of recorded maps of a campaign, and what is raced on of it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "bench/campaign.hpp"

namespace pathrace::bench {

/// Settles the campaign's folder of maps, as an absolute path: `given` (of the command line), else the file's
/// own, else `usual` for a campaign that selects recorded maps and names no folder. A campaign that was given
/// a folder, or names one, and selects nothing from it gets [[scenarios]] for everything that the folder
/// offers within the campaign's limits; what is left out is added to `left_out`, a line each.
///
/// Settling a settled campaign changes nothing. Throws InputError for a folder that offers nothing.
void settle_maps(Campaign& campaign, const std::optional<std::filesystem::path>& given,
                 const std::optional<std::filesystem::path>& usual, std::vector<std::string>& left_out);

}  // namespace pathrace::bench
