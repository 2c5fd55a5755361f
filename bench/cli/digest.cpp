// `digest`: one number for everything a run computed.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "bench/cli/command.hpp"
#include "bench/run_folder.hpp"
#include "core/hash.hpp"
#include "core/record.hpp"

namespace pathrace::bench::cli {
namespace {

int digest_command(const std::string& folder, bool json) {
  const results::Store store = open_store({folder});
  const std::vector<KeyedDigest> rows = store.digests();
  const std::string text = hex(campaign_digest(rows));
  if (!json) {
    fmt::print("{}\n", text);
    return done;
  }
  const auto timed =
      std::count_if(rows.begin(), rows.end(), [](const KeyedDigest& row) { return row.timed; });
  const nlohmann::ordered_json object = {
      {"digest", text}, {"trials", store.identity().trials}, {"recorded", rows.size()}, {"timed", timed}};
  fmt::print("{}\n", object.dump());
  return done;
}

}  // namespace

void add_digest(CLI::App& app) {
  auto folder = std::make_shared<std::string>();
  auto json = std::make_shared<bool>(false);
  CLI::App* options =
      add_command(app, "digest", "print the campaign digest of a run: equal results, equal digest",
                  "pathrace digest runs/starter-1", [=] { return digest_command(*folder, *json); });
  options->add_option("folder", *folder, "the folder of a run")->required()->type_name("DIR");
  options->add_flag("--json", *json, "print one JSON object: digest, trials, recorded, timed");
}

}  // namespace pathrace::bench::cli
