// What worldspawn asks of the light of the whole level.
#pragma once

#include "formats/levels/entities.h"
#include "math/vec.h"

namespace temblor::compiler {

// Darkness in corners: light falls off with how much lies within `depth` of a point.
struct DirtSettings {
  bool on = false;
  float depth = 128, scale = 1, gain = 1, angle_deg = 88;
};

struct BounceSettings {
  int count = 0;
  float scale = 1;
  bool styled = false;    // whether light of other styles than 0 bounces, in its own style
  float color_scale = 0;  // 0: every surface is gray, 1: it has its texture's color
};

struct LightSettings {
  float distance_scale = 1;  // _dist: of every light's `wait`
  float range = 0.5f;        // _range: from light to light map
  float gamma = 1;           // _gamma
  float max_light = 0;       // _maxlight; 0: none
  float angle_scale = 0.5f;  // _anglescale, for those who do not say
  float min_light = 0;       // worldspawn's own "light" or "_minlight"
  math::Vec3 min_light_color{1.0f};
  bool min_light_dirt = false;
  DirtSettings dirt;
  BounceSettings bounce;
};

LightSettings light_settings_of(const formats::Entity& worldspawn);

}  // namespace temblor::compiler
