// `scenarios list`: the library's finite list, with proven optima and hashes, and on request with features.
#include <fmt/format.h>

#include <memory>

#include "bench/cli/options.hpp"
#include "bench/cli/scenarios/listing.hpp"
#include "bench/cli/scenarios/verb.hpp"
#include "bench/describe.hpp"
#include "bench/executors.hpp"
#include "core/error.hpp"
#include "scenarios/library.hpp"
#include "scenarios/repeats.hpp"
#include "scenarios/sets.hpp"

namespace pathrace::bench::cli {
namespace {

struct ListOptions {
  std::string family;
  std::string set;
  bool features = false;
  bool json = false;
  bool csv = false;
  RunOptions executor;
};

// Ids below a prefix that ends at a slash: "trap-l", "dense/20-20", "trap-l/20/".
bool below(const std::string& id, std::string prefix) {
  if (prefix.empty()) return true;
  if (prefix.back() != '/') prefix += '/';
  return (id + '/').starts_with(prefix);
}

std::vector<std::string> chosen_ids(const scenarios::Library& library, const ListOptions& options) {
  std::vector<std::string> ids;
  const std::vector<std::string> listed =
      options.set.empty() ? library.list() : scenarios::ids_of(scenarios::find_set(options.set), library);
  for (const std::string& id : listed) {
    if (below(id, options.family)) ids.push_back(id);
  }
  if (ids.empty()) {
    throw InputError(fmt::format("--family: nothing in the {} begins with '{}'",
                                 options.set.empty() ? "library" : "set", options.family));
  }
  return ids;
}

// Of the library's list alone: a set holds what it was made of.
void say_what_repeats(const ListOptions& options) {
  std::string text;
  for (const scenarios::Repeat& repeat : scenarios::repeats()) {
    if (!below(std::string(repeat.id), options.family)) continue;
    text += fmt::format("{}{} ({})", text.empty() ? "" : ", ", repeat.id, repeat.earlier);
  }
  if (!text.empty()) fmt::print(stderr, "not listed, since they repeat an earlier question: {}\n", text);
}

std::vector<results::ScenarioRow> described(const scenarios::Library& library,
                                            const std::vector<std::string>& ids, const ListOptions& options) {
  std::vector<results::ScenarioRow> rows(ids.size());
  const auto executor = make_executor(options.executor.backend, options.executor.threads);
  for_each_index(*executor, ids.size(), 1,
                 [&](std::size_t i) { rows[i] = describe(library.load(ids[i]), options.features); });
  return rows;
}

int list_scenarios(const ListOptions& options) {
  require_backend(options.executor);
  const scenarios::Library library;
  const auto rows = described(library, chosen_ids(library, options), options);
  if (options.set.empty()) say_what_repeats(options);
  if (options.json) {
    print_json(rows, options.features);
  } else if (options.csv) {
    print_csv(rows, options.features);
  } else {
    print_table(rows, options.features);
  }
  return done;
}

}  // namespace

void add_scenarios_list(CLI::App& parent) {
  auto options = std::make_shared<ListOptions>();
  options->executor.threads = std::min(core_count(), max_threads);
  CLI::App* verb = add_verb(parent, "list", "the library's list, with proven optima and hashes",
                            "--family trap-l/20 --features", [options] { return list_scenarios(*options); });
  verb->add_option("--family", options->family, "only ids below this prefix")->type_name("PREFIX");
  verb->add_option("--set", options->set, "the scenarios of this set (see scenarios sets)")->type_name("SET");
  verb->add_flag("--features", options->features, "compute how hard each scenario is as well");
  CLI::Option* json = verb->add_flag("--json", options->json, "print a JSON array");
  verb->add_flag("--csv", options->csv, "print the columns of scenarios.csv")->excludes(json);
  verb->add_option("--threads", options->executor.threads, "scenarios side by side (default: the cores)")
      ->check(CLI::Range(1, max_threads))
      ->type_name("N");
  verb->add_option("--backend", options->executor.backend, "serial, openmp, tbb or threads (default: tbb)")
      ->type_name("NAME");
}

}  // namespace pathrace::bench::cli
