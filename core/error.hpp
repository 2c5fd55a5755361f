// What can go wrong outside a trial, by who has to act.
#pragma once

#include <stdexcept>

namespace pathrace {

/// The user gave something wrong: one line that names file, line, value and what was expected. Exit code 2.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A scenario that cannot be one: an empty grid, a blocked start. Exit code 2 at the door, verdict
/// `bad_scenario` inside a campaign.
class InvalidScenario : public InputError {
 public:
  using InputError::InputError;
};

/// The machine refused: a folder that cannot be written, a full disk. Exit code 3.
class EnvironmentError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A planner's honest "not for me": a move rule or a kind of scenario that it does not handle.
class Unsupported : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace pathrace
