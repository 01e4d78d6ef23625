// How a model is lit: by the floor below it and by dynamic lights, shaded as if from one fixed direction, so
// that it looks solid (Abrash, "Quake's Triangle Models").
#pragma once

#include <array>
#include <cstdint>

#include "base/arena.h"
#include "render/alias/place_alias.h"
#include "render/color/color_tables.h"
#include "render/frame.h"

namespace temblor::render {

struct AliasLight {
  // 0 to 255: everywhere, and where the light falls straight on.
  float ambient = 0, shade = 0;
  bool full_bright = false;
  math::Vec3 color{1.0f};  // its brightest part is 1; gray but for kRgb
};

AliasLight light_alias(const Scene& scene, const AliasInstance& instance, PixelFormat format,
                       bool colored_light);

// By number of the normal, in the units of TriangleJob's `colors`.
using LightOfNormals = std::array<float, 256>;
LightOfNormals light_normals(const AliasLight& light, const AliasPlacement& placement, PixelFormat format);

// TriangleJob's `colors` for an instance: the game's, or with a player's own in place of the shirt's and
// trousers' rows.
const void* instance_colors(const ColorTables& tables, const AliasInstance& instance, PixelFormat format,
                            base::Arena& arena);

}  // namespace temblor::render
