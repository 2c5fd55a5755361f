// The campaigns that come with the program: files of campaigns/ that CMake writes into builtin_campaigns.inc.
#include "bench/campaign.hpp"
#include "core/error.hpp"
#include "core/names.hpp"

namespace pathrace::bench {
namespace {

struct Builtin {
  std::string_view name;
  std::string_view toml;
};

constexpr Builtin builtins[] = {
#include "bench/builtin_campaigns.inc"
};

}  // namespace

Campaign builtin_campaign(std::string_view name) {
  for (const Builtin& builtin : builtins) {
    if (builtin.name == name) return parse_campaign(builtin.toml, "built-in campaign " + std::string(name));
  }
  throw InputError(unknown_name("campaign", name, builtin_campaigns()));
}

std::vector<std::string> builtin_campaigns() {
  std::vector<std::string> names;
  for (const Builtin& builtin : builtins) names.emplace_back(builtin.name);
  return names;
}

}  // namespace pathrace::bench
