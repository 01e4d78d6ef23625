// A level before visibility and light are worked out: the output of the BSP stage.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/function_ref.h"
#include "compiler/vis/portals.h"
#include "formats/levels/bsp.h"

namespace temblor::compiler {

// What brushes (worldspawn, func_group, func_detail and brush entities alike) ask of the light on their
// faces, which a .bsp has no room for. The keys are named as in the .map: _phong, _phong_angle, ...
struct SurfaceKeys {
  float phong_angle_deg = 0;          // 0: flat
  float phong_angle_concave_deg = 0;  // 0: as phong_angle_deg
  std::int32_t phong_group = 0;
  float min_light = 0;
  std::array<float, 3> min_light_color{1, 1, 1};
  bool casts_shadow = true;  // func_detail_illusionary and the like do not
  // Of one that casts a shadow only because it asks for this: _shadowself, _shadowworldonly.
  bool shadows_own_model_only = false, shadows_world_only = false;
  // _autominlight, who takes the light in the model's middle: 0 faces hidden whole, 1 all hidden luxels, -1
  // none.
  std::int8_t auto_min_light = 0;
  bool takes_dirt = true;
  bool takes_bounce = true;
  bool ignores_light = false;   // _lightignore
  bool lights_liquids = false;  // _litwater: liquids have light maps
  float light_map_scale = 1;    // _lmscale: 0.5: twice as many samples each way
  float light_alpha = 1;        // _light_alpha: how much of the light a face lets not through
  bool operator==(const SurfaceKeys&) const = default;
};

// Calls visit(field) for each field of `keys`, a SurfaceKeys, const or not: for whoever saves or hashes all.
template <typename Keys, typename Visit>
void visit_fields(Keys& keys, const Visit& visit) {
  visit(keys.phong_angle_deg), visit(keys.phong_angle_concave_deg), visit(keys.phong_group);
  visit(keys.min_light);
  for (auto& part : keys.min_light_color) visit(part);
  visit(keys.shadows_own_model_only), visit(keys.shadows_world_only), visit(keys.auto_min_light);
  visit(keys.casts_shadow), visit(keys.takes_dirt), visit(keys.takes_bounce), visit(keys.ignores_light);
  visit(keys.lights_liquids);
  visit(keys.light_map_scale), visit(keys.light_alpha);
}

// Width and height of a texture in texels; some texture alignments are measured in whole textures.
using TextureSize = base::FunctionRef<math::Vec2d(std::string_view name)>;

// What becomes of an entity that has brushes.
struct BrushEntity {
  bool is_in_level = false;  // worldspawn is; what is part of it, or has no brush with a volume, is not
  std::string model;         // "*1", ...; empty: the world
  std::string origin;        // of its origin brush; empty: its own
  bool operator==(const BrushEntity&) const = default;
};

struct Draft {
  formats::Bsp bsp;  // no visibility; no light: styles 255, offsets -1
  PortalSet portals;
  std::vector<SurfaceKeys> surface_keys;    // at least one
  std::vector<std::uint32_t> keys_of_face;  // by face, into surface_keys
  std::vector<BrushEntity> brush_entities;  // of the map, in its order
};

}  // namespace temblor::compiler
