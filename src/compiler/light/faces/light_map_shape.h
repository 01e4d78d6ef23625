// The grids of luxels on which light is measured. Every face has one with a luxel for every 16 texels, which
// every engine reads. Faces with _lmscale or _world_units_per_luxel have another one, coarser or finer, which
// only newer engines read.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "compiler/light/surface_keys.h"
#include "math/vec.h"
#include "world/level.h"

namespace temblor::compiler {

// Where luxels lie in the space of a face's model: luxel (x, y) is where dot(position, x_axis) + x_offset ==
// x, and y likewise. The numbers are those of DECOUPLED_LM.
struct LuxelAxes {
  math::Vec3 x_axis{0.0f};
  float x_offset = 0;
  math::Vec3 y_axis{0.0f};
  float y_offset = 0;
};

// One grid. Its luxels are at multiples of `texels` in the texture's coordinates, or, if it is decoupled,
// where `axes` say.
struct LightMapShape {
  std::uint32_t face = 0;
  std::int32_t texels = 16;                    // between luxels: a power of two, 1 to 128
  std::array<std::int32_t, 2> texture_mins{};  // texture coordinates of the first luxel
  std::int32_t width = 0, height = 0;          // in luxels
  bool is_decoupled = false;
  LuxelAxes axes;  // of a decoupled grid

  std::size_t size() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
};

// Grids with more luxels are left out, so that a level takes neither forever nor all memory.
constexpr std::size_t kMaxFaceLuxels = std::size_t{1} << 20, kMaxLevelLuxels = std::size_t{1} << 25;

// Makes the grids: map i belongs to face i; after these, in the order of the faces, come those of other
// scales, for faces that get light, at most one for each. Decoupled grids of faces in one plane have luxels
// at the same places, so that no seam shows between them. `io_too_fine` gets the faces whose grid would have
// too many luxels.
std::vector<LightMapShape> make_light_map_shapes(const world::Level& level, const FaceKeys& keys,
                                                 const std::vector<bool>& gets_light,
                                                 std::vector<std::uint32_t>& io_too_fine);

// The axes of any grid.
LuxelAxes find_luxel_axes(const world::Level& level, const LightMapShape& shape);

// Luxel (x, y) of a grid has the texture coordinates first + x * per_x + y * per_y.
struct LuxelTexels {
  math::Vec2d first{0.0}, per_x{0.0}, per_y{0.0};
};
// If the grid's axes span no plane, all luxels are at `first`.
LuxelTexels find_luxel_texels(const world::Level& level, const LightMapShape& shape);

// A point in the face's plane, in the space of its model, and how far luxels are apart.
struct LuxelPlaces {
  math::Vec3d first{0.0}, per_x{0.0}, per_y{0.0};
};
// The places of a decoupled grid's luxels.
LuxelPlaces find_luxel_places(const world::Level& level, const LightMapShape& shape);

}  // namespace temblor::compiler
