// A level as a scene for the renderer, without a running game: the world with its doors, lifts, and buttons
// in their initial positions. `render` and `bench` draw it.
#pragma once

#include <memory>
#include <vector>

#include "render/scene.h"
#include "world/animation.h"
#include "world/level.h"
#include "world/spawn_rules.h"

namespace temblor::app {

struct LevelScene {
  std::shared_ptr<const world::Level> level;
  std::vector<render::BrushModelInstance> brush_models;
  world::LightStylePatterns light_styles;
};

// Places every entity with a model "*N" at its `origin`, except those that `rules` exclude, and those that
// are invisible in the game: triggers, gates of unfinished episodes, and entities with an opacity of 0.
LevelScene make_level_scene(std::shared_ptr<const world::Level> level, const world::SpawnRules& rules = {});

// Returns the scene that `camera` sees, `time_s` seconds into the level. Valid while `level_scene` lives.
render::Scene make_scene(const LevelScene& level_scene, const render::Camera& camera, double time_s,
                         world::LightStyleMode light_styles = world::LightStyleMode::kFlickering);

}  // namespace temblor::app
