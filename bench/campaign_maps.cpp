#include "bench/campaign_maps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/error.hpp"
#include "scenarios/library.hpp"

namespace pathrace::bench {
namespace {

namespace fs = std::filesystem;

bool is_below(const fs::path& file, const fs::path& folder) {
  const fs::path relative = file.lexically_relative(folder);
  return !relative.empty() && *relative.begin() != "..";
}

bool selects_recorded(const ScenarioChoice& choice) {
  return std::any_of(choice.select.begin(), choice.select.end(), [](const std::string& pattern) {
    return pattern.starts_with("movingai/") || pattern.starts_with("ros/");
  });
}

bool selects_recorded(const Campaign& campaign) {
  return std::any_of(campaign.scenarios.begin(), campaign.scenarios.end(),
                     [](const ScenarioChoice& choice) { return selects_recorded(choice); });
}

bool selects_from_folder(const Campaign& campaign) {
  return std::any_of(campaign.scenarios.begin(), campaign.scenarios.end(), [&](const ScenarioChoice& choice) {
    return selects_recorded(choice) || (choice.map && is_below(choice.map->file, *campaign.maps));
  });
}

void add_offer(Campaign& campaign, std::vector<std::string>& left_out) {
  const scenarios::Library library(campaign.maps);
  const scenarios::Offer offer = library.offer(campaign.limits);
  for (std::string& line : scenarios::summary(offer.left_out)) left_out.push_back(std::move(line));
  if (offer.ids.empty() && offer.files.empty()) {
    throw InputError(fmt::format("{}: holds no map to race on{}", campaign.maps->string(),
                                 left_out.empty() ? "" : "; " + left_out.front()));
  }
  if (!offer.ids.empty()) {
    ScenarioChoice choice;
    choice.select = offer.ids;
    campaign.scenarios.push_back(std::move(choice));
  }
  for (const fs::path& file : offer.files) {
    ScenarioChoice choice;
    choice.map = MapChoice{};
    choice.map->file = file;
    choice.map->queries = campaign.limits.queries_per_map;
    campaign.scenarios.push_back(std::move(choice));
  }
}

fs::path settled(const fs::path& folder) {
  return fs::absolute(folder).lexically_normal();
}

}  // namespace

void settle_maps(Campaign& campaign, const std::optional<fs::path>& given,
                 const std::optional<fs::path>& usual, std::vector<std::string>& left_out) {
  if (given) campaign.maps = settled(*given);
  if (!campaign.maps) {
    if (usual && selects_recorded(campaign)) campaign.maps = settled(*usual);
    return;
  }
  if (!selects_from_folder(campaign)) add_offer(campaign, left_out);
}

}  // namespace pathrace::bench
