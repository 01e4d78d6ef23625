// What the rules of movement depend on; the stock values.
#pragma once

namespace temblor::movement {

// Console variables by their stock names (sv_gravity and so on; edge_friction is "edgefriction").
struct Settings {
  float gravity = 800;        // units a second, each second
  float max_velocity = 2000;  // along each axis
  float friction = 4, edge_friction = 2, stop_speed = 100, accelerate = 10, max_speed = 320;
  bool no_step = false;
};

// A floor is what is less steep than this (z of its normal).
constexpr float kFloorNormal = 0.7f;
constexpr float kStepHeight = 18;

}  // namespace temblor::movement
