// Arcs around the crosshair that point at the sources of damage, and vanish within a second.
#pragma once

#include <vector>

#include "client/hud/panel.h"
#include "client/session/client_state.h"
#include "math/vec.h"
#include "render/scene.h"

namespace temblor::client {

class DamageArcs {
 public:
  void begin_level() { hits_.clear(); }
  // Damage by the level itself (falls, liquids), which servers place at the origin, has no direction.
  void advance(const Events& events, double time_s);
  // The arcs follow when the camera turns.
  void draw(const Panel& panel, const render::Camera& camera, double time_s) const;

 private:
  struct Hit {
    math::Vec3 from_world;
    double since_s;
  };
  std::vector<Hit> hits_;
};

}  // namespace temblor::client
