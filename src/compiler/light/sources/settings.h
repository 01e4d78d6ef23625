// The keys of worldspawn that control the light of the whole level.
#pragma once

#include "formats/levels/entities.h"
#include "math/vec.h"

namespace temblor::compiler {

// Dirt (shadows/dirt.h): corners are darker, depending on what is within `depth` units of a point.
struct DirtSettings {
  bool on = false;            // _dirt: lights without the key take dirt
  bool is_forbidden = false;  // the mapper's options leave it out, whatever the keys say
  bool is_random = false;     // _dirtmode 1: other directions at each point
  float depth = 128, scale = 1, gain = 1, angle_deg = 88;  // _dirtdepth, _dirtscale, ...

  // Whether a light takes dirt; `key`: its own _dirt, 0: none.
  bool is_taken(float key) const { return !is_forbidden && (key > 0 || (on && key >= 0)); }
};

// Bounced light (bounce.h).
struct BounceSettings {
  int count = 0;             // _bounce: how often light bounces
  float scale = 1;           // _bouncescale
  bool styled = false;       // _bouncestyled: switchable lights bounce, too
  float color_scale = 0;     // _bouncecolorscale; 0: surfaces are gray, 1: they have their texture's color
  float angle_scale = 0.5f;  // LightSettings::angle_scale
};

// All settings, with their defaults.
struct LightSettings {
  float distance_scale = 1;  // _dist: scales every light's `wait`
  float range = 0.5f;        // _range: factor from light values to light map steps
  float gamma = 1;           // _gamma
  float max_light = 0;       // _maxlight, in light map steps; 0: no limit
  float angle_scale = 0.5f;  // _anglescale, for lights without the key
  float min_light = 0;       // _minlight, or worldspawn's "light"
  math::Vec3 min_light_color{1.0f};
  bool min_light_dirt = false;
  bool adds_min_light = false;       // _addmin: minimum light is added to all light
  bool spots_end_at_target = false;  // _spotlightautofalloff
  int light_map_texels = 0;          // _lightmap_scale: between luxels, of all faces; 0: not given
  DirtSettings dirt;
  BounceSettings bounce;
  bool has_hdr = false;         // also pack light without an upper limit (--hdr)
  bool has_directions = false;  // also sum up where light comes from (--lux)
  float units_per_luxel = 0;    // _world_units_per_luxel, for brushes without their own; 0: off
};

// Reads the settings; missing or invalid keys keep their defaults.
LightSettings read_light_settings(const formats::Entity& worldspawn);

}  // namespace temblor::compiler
