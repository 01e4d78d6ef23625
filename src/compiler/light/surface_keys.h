// The keys by which mappers control the light on the faces of a brush entity.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "formats/levels/bsp.h"
#include "formats/levels/entities.h"

namespace temblor::compiler {

// The name of a texture in lower case, padded with zeros.
using TextureKey = std::array<std::uint8_t, 16>;
TextureKey make_texture_key(std::string_view texture);
// A name of lights or shadows (sources/switchable_styles.h), padded with zeros; all zeros: none.
using StyleName = std::array<std::uint8_t, 64>;

// The options of a brush for the light on its faces. They apply to worldspawn, func_group, func_detail and
// brush entities alike. A .bsp cannot store it. The names are those of the keys in the .map: _phong,
// _phong_angle,
// ...
struct SurfaceKeys {
  float phong_angle_deg = 0;          // 0: flat
  float phong_angle_concave_deg = 0;  // 0: the same as phong_angle_deg
  std::int32_t phong_group = 0;
  float min_light = 0;
  std::array<float, 3> min_light_color{1, 1, 1};
  // _minlight_exclude, _minlight_exclude2 to _minlight_exclude9: textures without minimum light.
  std::array<TextureKey, 9> min_light_excludes{};
  bool mottles_min_light = false;  // _minlight_mottle: minimum light has a pattern
  bool casts_shadow = true;        // func_detail_illusionary does not
  // If the brush casts a shadow only because of _shadowself or _shadowworldonly.
  bool shadows_own_model_only = false, shadows_world_only = false;
  // _autominlight. Which luxels take the light at the model's center: 0: those of completely hidden faces, 1:
  // all hidden ones, and all others as minimum light, -1: none.
  std::int8_t auto_min_light = 0;
  bool takes_dirt = true;
  bool takes_bounce = true;
  float bounce_scale = 1;               // _bouncescale: of the light that these faces send back
  bool ignores_light = false;           // _lightignore
  bool lights_liquids = true;           // _litwater or _splitturb: liquids get light maps
  std::int8_t takes_light_behind = -1;  // _light_twosided; -1: only liquids do
  float max_light = 0;                  // _maxlight; 0: no limit
  float light_color_scale = 1;          // _lightcolorscale: 0: gray
  std::uint32_t channels = 1;           // _object_channel_mask: bits of the channels that light these faces
  // _surflight_group, _surflight_style, _surflight_color and _surflight_rescale, for faces that _surface
  // makes shine. -1: as the light says.
  std::int32_t surface_light_group = 0, surface_light_style = -1;
  std::array<float, 3> surface_light_color{-1, -1, -1};
  std::int8_t surface_light_rescale = -1;
  StyleName surface_light_name{};  // _surflight_targetname: lights whose style these take
  // _lmscale or _lightmap_scale; 0.5: twice as many luxels along each axis.
  float light_map_scale = 1;
  // _world_units_per_luxel: luxels lie on the plane, not on the texture. 0: as worldspawn says; below 0: off.
  float units_per_luxel = 0;
  float light_alpha = 1;             // _light_alpha: the share of light that a face stops
  StyleName shadow_name{};           // of a brush of the world whose shadow can be switched
  bool shadow_hides_leaves = false;  // has such a shadow, and visibility ends at the brush
  bool operator==(const SurfaceKeys&) const = default;
};

// Calls visit(field) for each field of `keys`, a SurfaceKeys, const or not: for saving and hashing.
template <typename Keys, typename Visit>
void visit_fields(Keys& keys, const Visit& visit) {
  visit(keys.phong_angle_deg), visit(keys.phong_angle_concave_deg), visit(keys.phong_group);
  visit(keys.min_light), visit(keys.mottles_min_light);
  for (auto& part : keys.min_light_color) visit(part);
  for (auto& texture : keys.min_light_excludes)
    for (auto& letter : texture) visit(letter);
  visit(keys.shadows_own_model_only), visit(keys.shadows_world_only), visit(keys.auto_min_light);
  visit(keys.casts_shadow), visit(keys.takes_dirt), visit(keys.takes_bounce), visit(keys.ignores_light);
  visit(keys.lights_liquids), visit(keys.takes_light_behind), visit(keys.bounce_scale);
  visit(keys.max_light), visit(keys.light_color_scale), visit(keys.channels);
  visit(keys.surface_light_group), visit(keys.surface_light_style);
  for (auto& part : keys.surface_light_color) visit(part);
  visit(keys.surface_light_rescale);
  for (auto& letter : keys.surface_light_name) visit(letter);
  visit(keys.light_map_scale), visit(keys.units_per_luxel), visit(keys.light_alpha);
  for (auto& letter : keys.shadow_name) visit(letter);
  visit(keys.shadow_hides_leaves);
}

// Reads the keys of worldspawn, a func_group, a func_detail or a brush entity. Unknown keys and values that
// are not numbers are ignored. Brush entities that the game moves cast a shadow only if they ask for it.
SurfaceKeys read_surface_keys(const formats::Entity& entity);

// Whether an entity's liquids have light maps (_litwater, or its other name _splitturb); nothing without the
// key.
std::optional<bool> read_lights_liquids(const formats::Entity& entity);

// The keys of all faces of a level.
struct FaceKeys {
  std::vector<SurfaceKeys> keys;       // at least one entry
  std::vector<std::uint32_t> of_face;  // by face, index into keys
};

// Returns the keys of a finished level, which no longer knows its brushes: each model's faces have the keys
// of the entity that shows it ("model" "*3").
FaceKeys find_face_keys(const formats::Bsp& bsp, std::span<const formats::Entity> entities);

}  // namespace temblor::compiler
