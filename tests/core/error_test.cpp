#include "core/error.hpp"

#include <gtest/gtest.h>

#include <type_traits>

namespace pathrace {
namespace {

// Whoever handles the user's errors also handles a scenario that cannot be one, and nothing else.
TEST(Errors, AreToldApartByWhoHasToAct) {
  EXPECT_TRUE((std::is_base_of_v<InputError, InvalidScenario>));
  EXPECT_FALSE((std::is_base_of_v<InputError, EnvironmentError>));
  EXPECT_FALSE((std::is_base_of_v<InputError, Unsupported>));
  EXPECT_FALSE((std::is_base_of_v<EnvironmentError, Unsupported>));
  EXPECT_TRUE((std::is_base_of_v<std::runtime_error, Unsupported>));
}

}  // namespace
}  // namespace pathrace
