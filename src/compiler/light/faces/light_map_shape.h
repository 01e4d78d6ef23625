// The grids of luxels that light is measured on: one for each face that every game reads, and for faces that
// ask for it by _lmscale a coarser or finer one besides.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "compiler/build/surface_keys.h"
#include "world/level.h"

namespace temblor::compiler {

struct LightMapShape {
  std::uint32_t face = 0;
  std::int32_t texels = 16;  // between luxels: a power of two, 1 to 128
  std::array<std::int32_t, 2> texture_mins{};
  std::int32_t width = 0, height = 0;  // luxels

  std::size_t size() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
};

// Map i is that of face i, every 16 texels; behind them, in the order of faces, come those of another scale,
// where a face gets light at all. One that would have more than a million luxels is left out.
std::vector<LightMapShape> light_map_shapes(const world::Level& level, const FaceKeys& keys,
                                            const std::vector<bool>& gets_light);

}  // namespace temblor::compiler
