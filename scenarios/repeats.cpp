#include "scenarios/repeats.hpp"

#include <algorithm>

namespace pathrace::scenarios {

const std::vector<Repeat>& repeats() {
  static const std::vector<Repeat> all = {
#define PATHRACE_REPEAT(id, earlier) Repeat{id, earlier},
#include "scenarios/repeats.def"
#undef PATHRACE_REPEAT
  };
  return all;
}

bool is_repeat(std::string_view id) {
  return std::any_of(repeats().begin(), repeats().end(),
                     [id](const Repeat& repeat) { return repeat.id == id; });
}

}  // namespace pathrace::scenarios
