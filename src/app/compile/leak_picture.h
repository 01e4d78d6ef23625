// Where a level leaks, to look at.
#pragma once

#include <span>

#include "base/bytes.h"
#include "base/result.h"
#include "formats/levels/bsp.h"
#include "math/vec.h"

namespace temblor::app {

// A PNG: the edges of the level's walls from above, and below that from the south, with the way through them
// in orange from a green dot, where it begins, to a red one outside.
base::Result<base::ByteVector> draw_leak(const formats::Bsp& bsp, std::span<const math::Vec3d> way_world);

}  // namespace temblor::app
