// A camera that the viewer flies through a level: for watching demos and for looking around. It slides along
// walls; doors and other brush models do not stop it.
#pragma once

#include "math/vec.h"
#include "render/scene.h"
#include "world/level.h"

namespace temblor::client {

class FreeCamera {
 public:
  // Where to fly, -1 to 1 each, in the view's directions; up is the world's.
  struct Directions {
    float forward = 0, right = 0, up = 0;
  };

  // Starts at another camera's place; keeps its field of view and levels its roll.
  void place(const render::Camera& camera);
  // Turns the camera, positive pitch down. Pitch stays within 90 degrees up and down.
  void turn(float pitch_deg, float yaw_deg);
  // Moves at `speed` units per second for `seconds`, and stays a few units away from walls. A camera outside
  // the level flies freely, so that it can come back. Without a level there are no walls.
  void fly(const Directions& directions, float speed, double seconds, const world::Level* level);
  // Whether the camera is in the open space of the level.
  bool is_inside(const world::Level& level) const;

  const render::Camera& camera() const { return camera_; }

 private:
  render::Camera camera_;
};

}  // namespace temblor::client
