#include "scenarios/generated.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "scenarios/text.hpp"

namespace pathrace::scenarios::detail {
namespace {

std::string form_of(const GeneratedCard& card) {
  const std::string main = card.main.empty() ? "" : "-<" + card.main + ">";
  return fmt::format("{}/<n>{}[,key=value...]/<seed>", card.name, main);
}

[[noreturn]] void refuse(const std::string& id, const std::string& what) {
  throw InputError(fmt::format("scenario '{}': {}", id, what));
}

// "20" or "20-30", without the named parameters.
void read_size(const std::string& id, const GeneratedCard& card, std::string_view text, SizePart& size) {
  const std::size_t dash = text.find('-');
  const bool has_main = dash != std::string_view::npos;
  if (has_main == card.main.empty()) refuse(id, "expected the form " + form_of(card));
  size.n = id_number(id, "n", text.substr(0, dash), least_side, most_side);
  if (has_main) size.values[card.main] = text.substr(dash + 1);
}

std::string canonical_part(int n, const GeneratedCard& card, const std::vector<ParameterCard>& cards,
                           const ParameterValues& values) {
  std::string part = std::to_string(n);
  if (!card.main.empty()) part += "-" + values.at(card.main);
  for (const ParameterCard& parameter : cards) {
    const std::string& value = values.at(parameter.name);
    if (parameter.name == card.main || value == parameter.default_value) continue;
    part += fmt::format(",{}={}", parameter.name, value);
  }
  return part;
}

}  // namespace

SizePart read_parts(const std::string& id, const GeneratedCard& card,
                    const std::vector<std::string_view>& parts) {
  require_parts(id, form_of(card), parts, 2);
  id_number(id, "seed", parts[1], 0, most_seed);
  const std::vector<std::string_view> pieces = split_at(parts[0], ',');
  SizePart size;
  read_size(id, card, pieces[0], size);
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    const std::size_t equals = pieces[i].find('=');
    if (equals == std::string_view::npos) {
      refuse(id, fmt::format("expected key=value, got '{}'", pieces[i]));
    }
    const std::string key(pieces[i].substr(0, equals));
    const bool fresh = size.values.emplace(key, pieces[i].substr(equals + 1)).second;
    if (!fresh) refuse(id, fmt::format("gives '{}' twice", key));
  }
  return size;
}

void require_canonical(const std::string& id, const GeneratedCard& card,
                       const std::vector<std::string_view>& parts, const std::vector<ParameterCard>& cards,
                       const ParameterValues& values) {
  const int n = id_number(id, "n", parts[0].substr(0, parts[0].find_first_of("-,")), least_side, most_side);
  const std::string part = canonical_part(n, card, cards, values);
  if (part != parts[0]) {
    refuse(id, fmt::format("one question has one id; write it as {}/{}/{}", card.name, part, parts[1]));
  }
}

void require_useful(const std::string& id, const Placement& placement) {
  if (placement.ends != Ends::random && placement.difficulty != Placement{}.difficulty) {
    refuse(id, "'difficulty' needs ends=random");
  }
}

void naming(const std::string& id, const std::function<void()>& read) {
  try {
    read();
  } catch (const InputError& fault) {
    refuse(id, fault.what());
  }
}

Family family_of(const GeneratedCard& card, std::vector<ParameterCard> cards) {
  std::vector<std::string> prefixes;
  for (const std::string& size : card.sizes) prefixes.push_back(card.name + "/" + size);
  return {card.name, form_of(card), card.summary, thirty_seeds(prefixes), std::move(cards), {}};
}

}  // namespace pathrace::scenarios::detail
