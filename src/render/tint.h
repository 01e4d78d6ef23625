// A color blended over the finished view: damage, pickups, the inside of liquids.
#pragma once

#include "math/vec.h"

namespace temblor::render {

struct Tint {
  math::Vec3 color{0.0f};  // 0 to 255
  float opacity = 0;       // 0 to 1
};

}  // namespace temblor::render
