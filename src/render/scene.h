// What to draw: everything a frame depends on, given from outside. The renderer keeps nothing of it.
#pragma once

#include <span>

#include "math/vec.h"
#include "world/animation.h"
#include "world/level.h"

namespace temblor::render {

enum class Projection { kPerspective, kOrthographic };

struct Camera {
  math::Vec3 origin_world{0.0f};
  math::Vec3 angles_deg{0.0f};  // pitch (down positive), yaw, roll
  // Horizontal field of view of a 4:3 picture, 10 to 170. Wider pictures see more at the sides, narrower ones
  // more above and below.
  float fov_deg = 90;
  Projection projection = Projection::kPerspective;
  float units_per_pixel = 0;  // orthographic only; 0: the level fits the picture
};

// A door, a lift, a button: one of the level's brush models at a place of its own.
struct BrushModelInstance {
  world::ModelIndex model{};
  math::Vec3 origin_world{0.0f};  // where the model's own origin (0,0,0) has moved to
  math::Vec3 angles_deg{0.0f};
  int frame = 0;  // not 0: alternate texture animation
};

struct Scene {
  const world::Level* level = nullptr;
  Camera camera;
  std::span<const BrushModelInstance> brush_models;
  double time_s = 0;
  world::LightStyleValues light_styles = world::light_as_stored();
};

}  // namespace temblor::render
