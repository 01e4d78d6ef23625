// A level as the light compiler sees it: the game's own, with every face at the place where the level starts.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "base/result.h"
#include "compiler/build/surface_keys.h"
#include "compiler/light/faces/light_map_shape.h"
#include "compiler/light/rays/ray_scene.h"
#include "formats/images/palette.h"
#include "formats/levels/bsp.h"
#include "math/vec.h"
#include "world/level.h"

namespace temblor::compiler {

struct LitLevel {
  std::shared_ptr<const world::Level> level;
  FaceKeys keys;
  std::vector<std::uint32_t> model_of_face;  // 0: the world
  std::vector<math::Vec3> offset_of_model;   // its entity's origin
  std::vector<bool> gets_light;              // by face
  std::vector<LightMapShape> maps;           // light_map_shapes of all this

  const SurfaceKeys& keys_of(std::size_t face) const { return keys.keys[keys.of_face[face]]; }
  const math::Vec3& offset_of(std::size_t face) const { return offset_of_model[model_of_face[face]]; }
  // The face's vertices, clockwise from its front.
  std::vector<math::Vec3d> corners_world(std::size_t face) const;
};

// `bsp` is not lit. CHECKs that `keys` has as many faces as the level.
base::Result<LitLevel> make_lit_level(formats::Bsp bsp, FaceKeys keys);

// Faces that stop light: of the world all but sky and liquids, and what asks to cast a shadow. Surfaces of
// opaque triangles are face numbers. Texels stay the level's. `palette`: what tints light through glass;
// without it glass is gray.
Occluders occluders_of(const LitLevel& lit, const std::optional<formats::Palette>& palette);

}  // namespace temblor::compiler
