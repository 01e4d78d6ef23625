// A camera that the viewer flies, through walls too: for watching demos and for looking around a level.
#pragma once

#include "math/vec.h"
#include "render/scene.h"

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
  // Moves at `speed` units per second for `seconds`.
  void fly(const Directions& directions, float speed, double seconds);

  const render::Camera& camera() const { return camera_; }

 private:
  render::Camera camera_;
};

}  // namespace temblor::client
