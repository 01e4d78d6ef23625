// The grids of luxels on which light is measured. Every face has one with a luxel for every 16 texels, which
// every engine reads. Faces with _lmscale have another one, coarser or finer, which only newer engines read.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "compiler/light/surface_keys.h"
#include "world/level.h"

namespace temblor::compiler {

// One grid. Its luxels are at multiples of `texels` in the texture's coordinates.
struct LightMapShape {
  std::uint32_t face = 0;
  std::int32_t texels = 16;                    // between luxels: a power of two, 1 to 128
  std::array<std::int32_t, 2> texture_mins{};  // texture coordinates of the first luxel
  std::int32_t width = 0, height = 0;          // in luxels

  std::size_t size() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
};

// Makes the grids: map i belongs to face i; after these, in the order of the faces, come those of other
// scales, for faces that get light. A scaled grid with more than a million luxels is left out.
std::vector<LightMapShape> make_light_map_shapes(const world::Level& level, const FaceKeys& keys,
                                                 const std::vector<bool>& gets_light);

}  // namespace temblor::compiler
