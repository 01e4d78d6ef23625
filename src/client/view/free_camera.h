// A camera that somebody flies, through walls and all: for recordings, and to look around.
#pragma once

#include "math/vec.h"
#include "render/scene.h"

namespace temblor::client {

class FreeCamera {
 public:
  // How much is wished for of each, -1 to 1, in the view's directions; up is the world's.
  struct Wishes {
    float forward = 0, right = 0, up = 0;
  };

  // From there it starts; it keeps the field of view.
  void place(const render::Camera& camera);
  // Added to where it looks. Pitch stays within 90 degrees up and down.
  void turn(float pitch_deg, float yaw_deg);
  // At `speed` units a second, for `seconds`.
  void fly(const Wishes& wishes, float speed, double seconds);

  const render::Camera& camera() const { return camera_; }

 private:
  render::Camera camera_;
};

}  // namespace temblor::client
