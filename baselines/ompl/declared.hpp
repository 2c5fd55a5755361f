// The parameters that a planner of OMPL declares about itself, as cards of the catalogue.
#pragma once

#include <ompl/base/GenericParam.h>

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/parameters.hpp"

namespace pathrace::baselines {

struct DeclaredParameter {
  ParameterCard card;  ///< the default is the library's
  /// A value in canonical spelling. Throws InputError.
  std::function<std::string(std::string_view)> canonical;
};

/// Numbers and switches. The range is the one that the library suggests, cut to what it accepts and widened
/// to hold the default.
std::vector<DeclaredParameter> declared_parameters(const ompl::base::ParamSet& parameters);

}  // namespace pathrace::baselines
