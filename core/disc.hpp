// A disc: what moves in a dynamic world.
#pragma once

#include "core/cell.hpp"

namespace pathrace {

struct Disc {
  Point centre;
  double radius = 0;

  friend bool operator==(const Disc&, const Disc&) = default;
};

}  // namespace pathrace
