#include "baselines/ompl_names.hpp"

namespace pathrace::baselines {

std::vector<std::string> ompl_names() {
  return {
#define PATHRACE_OMPL_TREE(name, ...) name,
#define PATHRACE_OMPL_BEST_TREE(name, ...) name,
#define PATHRACE_OMPL_BATCH(name, ...) name,
#define PATHRACE_OMPL_ROADMAP(name, ...) name,
#define PATHRACE_OMPL_CELL(name, ...) name,
#include "baselines/ompl/planners.def"
  };
}

}  // namespace pathrace::baselines
