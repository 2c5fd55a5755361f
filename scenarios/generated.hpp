// Generated families: `<name>/<n>[-<main>][,key=value...]/<seed>`.
//
// n is the side of the square map. A family may have one main parameter, such as a density, which always
// stands behind the size. Every other parameter stands there by name, in the order of the family's card, and
// only where it differs from its default: one question has one id.
//
// Where start and goal lie is a parameter of every family (scenarios/ends.hpp).
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/parameters.hpp"
#include "scenarios/ends.hpp"
#include "scenarios/family.hpp"

namespace pathrace::scenarios {

/// What a family says of itself beside its parameters.
struct GeneratedCard {
  std::string name;
  std::string summary;
  std::string main;                ///< name of the main parameter; empty: none
  Ends ends = Ends::own;           ///< what `ends=own` means; `own` itself: the drawing places start and goal
  std::vector<std::string> sizes;  ///< "20-30": what the library lists, thirty seeds each
};

namespace detail {

struct SizePart {
  int n = 0;
  ParameterValues values;  ///< the main parameter and what the id names
};

/// The parts after the family's name, taken apart. Throws InputError that names the id and shows the form.
SizePart read_parts(const std::string& id, const GeneratedCard& card,
                    const std::vector<std::string_view>& parts);

/// Throws InputError unless the parameters stand in the id as they should; `values`: every parameter.
void require_canonical(const std::string& id, const GeneratedCard& card,
                       const std::vector<std::string_view>& parts, const std::vector<ParameterCard>& cards,
                       const ParameterValues& values);

/// Throws InputError when a difficulty is given that nothing would use.
void require_useful(const std::string& id, const Placement& placement);

/// Runs `read`; an InputError comes out with the id in front.
void naming(const std::string& id, const std::function<void()>& read);

Family family_of(const GeneratedCard& card, std::vector<ParameterCard> cards);

}  // namespace detail

/// `Settings` derives from Placement; `fields` lists what it adds. `draw(settings, n, stream)` returns a
/// Sketch; its start and goal count only where the card's and the id's ends are both `own`.
template <typename Settings, typename Draw>
Family generated_family(const GeneratedCard& card, std::vector<Field<Settings>> fields, Draw draw) {
  for (Field<Placement>& field : placement_fields()) {
    fields.push_back({std::move(field.card), std::move(field.read), std::move(field.print)});
  }
  const Schema<Settings> schema(std::move(fields));
  Family family = detail::family_of(card, schema.cards());
  family.make = [card, schema, draw, cards = family.parameters](const std::string& id,
                                                                const std::vector<std::string_view>& parts) {
    const detail::SizePart size = detail::read_parts(id, card, parts);
    Settings settings;
    detail::naming(id, [&] { settings = schema.settings(size.values); });
    detail::require_canonical(id, card, parts, cards, schema.print(settings));
    detail::require_useful(id, settings);
    const Ends ends = settings.ends == Ends::own ? card.ends : settings.ends;
    return certified(id, [&](Stream stream) -> std::optional<Sketch> {
      Sketch sketch = draw(settings, size.n, stream);
      if (ends == Ends::own || place_ends(sketch, ends, settings.difficulty, stream)) return sketch;
      return std::nullopt;
    });
  };
  return family;
}

}  // namespace pathrace::scenarios
