// What a level's worldspawn says of its air: sky, fog, and how clear its liquids are.
#pragma once

#include <optional>
#include <string>

#include "render/scene.h"
#include "world/level.h"

namespace temblor::client {

struct LevelEnvironment {
  std::string skybox;  // empty: the sky's texture
  render::Fog fog;
  std::optional<float> water_alpha, slime_alpha, lava_alpha, teleport_alpha;  // 0 to 1

  // As the level has it; where it says nothing, as `otherwise`.
  render::LiquidAlpha liquid_alpha(const render::LiquidAlpha& otherwise) const;
};

// Keys "sky" (also "skyname", "qlsky"), "fog" ("DENSITY RED GREEN BLUE"), "wateralpha", "slimealpha",
// "lavaalpha" and "telealpha", each also with an underscore in front. What does not parse is left out.
LevelEnvironment environment_of(const world::Level& level);

}  // namespace temblor::client
