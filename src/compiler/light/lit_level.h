// The level as the light stage sees it: the game's own level, with every face where its model is when the
// level starts.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "base/result.h"
#include "compiler/light/faces/light_map_shape.h"
#include "compiler/light/rays/ray_scene.h"
#include "compiler/light/sources/switchable_styles.h"
#include "compiler/light/surface_keys.h"
#include "formats/images/palette.h"
#include "formats/levels/bsp.h"
#include "math/vec.h"
#include "world/level.h"

namespace temblor::compiler {

// Never changes once it is made.
struct LitLevel {
  std::shared_ptr<const world::Level> level;
  FaceKeys keys;
  std::vector<std::uint32_t> model_of_face;  // 0: the world
  std::vector<math::Vec3> offset_of_model;   // by model: its entity's origin
  std::vector<math::Vec3> center_of_model;   // by model: where _autominlight measures light
  // By model: the style of its switchable shadow (sources/switchable_styles.h); 0: none.
  std::vector<std::uint8_t> switch_style_of_model;
  BrushStyles styles_of_keys;                 // of brushes of the world
  std::vector<bool> gets_light;               // by face
  std::vector<LightMapShape> maps;            // all grids of luxels
  std::vector<std::uint32_t> too_fine_faces;  // whose own grid is left out, because it has too many luxels

  // The light options of a face's brush.
  const SurfaceKeys& surface_keys(std::size_t face) const { return keys.keys[keys.of_face[face]]; }
  // The style of the face's switchable shadow; 0: none.
  std::uint8_t switch_style(std::size_t face) const {
    return std::max(switch_style_of_model[model_of_face[face]], styles_of_keys.shadows[keys.of_face[face]]);
  }
  // The style that a face's brush gives to its surface lights; 0: none.
  std::uint8_t surface_light_style(std::size_t face) const {
    return styles_of_keys.surface_lights[keys.of_face[face]];
  }
  const math::Vec3& model_offset(std::size_t face) const { return offset_of_model[model_of_face[face]]; }
  // Whether light from behind reaches a face: a liquid, or as _light_twosided says.
  bool takes_light_behind(std::size_t face) const;
  // The face's vertices, clockwise seen from its front.
  std::vector<math::Vec3d> corners_world(std::size_t face) const;
};

// `bsp` has no light. `keys` has as many faces as the level (CHECKed). Fails if world::make_level() does.
base::Result<LitLevel> make_lit_level(formats::Bsp bsp, FaceKeys keys);

// Returns the faces that stop light: all of the world except sky and liquids, and those of other models that
// ask to cast a shadow. The surfaces of opaque triangles are face numbers. Refers to the level's texels.
// `palette`: tints light that passes through glass; without it glass is gray.
Occluders make_occluders(const LitLevel& lit, const std::optional<formats::Palette>& palette);

}  // namespace temblor::compiler
