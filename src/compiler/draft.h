// A level before visibility and light are worked out: the output of the BSP stage.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "base/function_ref.h"
#include "compiler/portals.h"
#include "formats/bsp.h"

namespace temblor::compiler {

// On what a brush entity's shadow falls.
enum class ShadowReceivers : std::uint8_t { kAll, kOwnModel, kWorld };

// What brushes (worldspawn, func_group, func_detail and brush entities alike) ask of the light on their
// faces, which a .bsp has no room for. The keys are named as in the .map: _phong, _phong_angle, ...
struct SurfaceKeys {
  float phong_angle_deg = 0;          // 0: flat
  float phong_angle_concave_deg = 0;  // 0: as phong_angle_deg
  std::int32_t phong_group = 0;
  float min_light = 0;
  std::array<float, 3> min_light_colour{1, 1, 1};
  bool casts_shadow = true;                                  // func_detail_illusionary and the like do not
  ShadowReceivers shadow_receivers = ShadowReceivers::kAll;  // _shadowself, _shadowworldonly
  std::int8_t auto_min_light =
      0;  // _autominlight: faces that are hidden whole; 1: all hidden luxels; -1: none
  bool takes_dirt = true;
  bool takes_bounce = true;
  bool ignores_light = false;  // _lightignore
  float light_map_scale = 1;   // _lmscale: 0.5: twice as many samples each way
  float light_alpha = 1;       // _light_alpha: how much of the light a face lets not through
  bool operator==(const SurfaceKeys&) const = default;
};

// Width and height of a texture in texels; some texture alignments are measured in whole textures.
using TextureSize = base::FunctionRef<math::Vec2d(std::string_view name)>;

struct Draft {
  formats::Bsp bsp;  // no visibility; no light: styles 255, offsets -1
  PortalSet portals;
  std::vector<SurfaceKeys> surface_keys;    // at least one
  std::vector<std::uint32_t> keys_of_face;  // by face, into surface_keys
};

}  // namespace temblor::compiler
