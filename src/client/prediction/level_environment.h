// The sky, fog, liquid opacity, and par time that a level's worldspawn asks for. All keys but `par` are those
// that other engines have established. Console variables and messages of the server are combined with them by
// the presentation.
#pragma once

#include <optional>
#include <string>

#include "render/scene.h"
#include "world/level.h"

namespace temblor::client {

struct LevelEnvironment {
  // Name of the skybox; empty: the level's sky texture.
  std::string skybox;
  render::Fog fog;
  // Opacities from 0 to 1; nothing for those that the level does not set.
  std::optional<float> water_alpha, slime_alpha, lava_alpha, teleport_alpha;
  // A good player's time for the level; 0: none.
  float par_s = 0;

  // The level's opacities; those of `fallback` that the level does not set.
  render::LiquidAlpha liquid_alpha(const render::LiquidAlpha& fallback) const;
};

// Parses the worldspawn keys "sky" (also "skyname", "qlsky"), "fog" ("DENSITY RED GREEN BLUE", colors 0 to
// 1), "wateralpha", "slimealpha", "lavaalpha", "telealpha" and "par" (seconds), each also with a leading
// underscore. Ignores values that do not parse. A level without entities has the default environment.
LevelEnvironment parse_environment(const world::Level& level);

}  // namespace temblor::client
