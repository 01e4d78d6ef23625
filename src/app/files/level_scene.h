// A level as it is drawn: the world, and its doors, lifts and buttons where the level puts them.
#pragma once

#include <memory>
#include <vector>

#include "render/scene.h"
#include "world/animation.h"
#include "world/level.h"

namespace temblor::app {

struct LevelScene {
  std::shared_ptr<const world::Level> level;
  std::vector<render::BrushModelInstance> brush_models;
  world::LightStylePatterns light_styles;
};

// Every entity with a model "*N" stands at its `origin` (0 0 0 without one), but for those that the game does
// not show: triggers, and gates of episodes that are still to be played.
LevelScene make_level_scene(std::shared_ptr<const world::Level> level);

// What `camera` looks at, `time_s` seconds into the level. Valid while `level_scene` lives.
render::Scene scene_at(const LevelScene& level_scene, const render::Camera& camera, double time_s);

}  // namespace temblor::app
