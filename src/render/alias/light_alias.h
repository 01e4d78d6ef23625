// The light on an alias model: the light of the floor below it plus dynamic lights, shaded as if from one
// fixed direction, so that the model looks solid. Each vertex is lit by its normal and light is interpolated
// across triangles (Gouraud shading; Abrash, "Quake's Lighting Model: Surface Caching", explains why models
// are lit in this way and the world is not). In indexed frames, the color of dynamic lights tints the model's
// colormap, in the way in which it tints surfaces (build_surface.h).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "base/arena.h"
#include "render/alias/place_alias.h"
#include "render/color/color_tables.h"
#include "render/frame_buffer.h"

namespace temblor::render {

// The light at the instance's position.
struct AliasLight {
  // 0 to 255. `ambient` reaches every vertex; `shade` is added where the light falls on it perpendicularly.
  float ambient = 0, shade = 0;
  bool full_bright = false;
  // Rgb frames: the largest component is 1. Indexed frames: white.
  math::Vec3 color{1.0f};
  // Indexed frames: the color of the strongest colored light, and the row of its tint table by how far it
  // dominates; row 0 is white light (tint_tables.h).
  std::array<float, 3> tint_color{1, 1, 1};
  std::size_t tint_row = 0;
};

// The floor has color only in rgb frames. Without `colored_light`, all light is white.
AliasLight light_alias(const Scene& scene, const AliasInstance& instance, PixelFormat format,
                       bool colored_light);

// By number of the normal, in the units of TriangleJob's `colors`.
using NormalLights = std::array<float, 256>;
NormalLights light_normals(const AliasLight& light, const AliasPlacement& placement, PixelFormat format);

// TriangleJob's `colors` for an instance: the game's table, or a copy in `arena` that is tinted by the light
// and in which the shirt's and pants' colors are replaced by the player's.
const void* instance_colors(const ColorTables& tables, const AliasInstance& instance, const AliasLight& light,
                            PixelFormat format, base::Arena& arena);

}  // namespace temblor::render
