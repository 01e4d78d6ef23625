// Fog that changes over time: a server's fog comes in over seconds.
#pragma once

#include <optional>

#include "net/server_message.h"
#include "render/scene.h"

namespace temblor::client {

class FogFade {
 public:
  // The level begins with its own fog.
  void begin_level(const render::Fog& fog) { *this = FogFade(fog); }
  // The server's last word, and when it was said (server time).
  void follow(const net::Fog& fog, double since_s);
  render::Fog at(double time_s) const;

  explicit FogFade(const render::Fog& fog = {}) : from_(fog), to_(fog) {}

 private:
  render::Fog from_, to_;
  double since_s_ = -1, fade_s_ = 0;
};

}  // namespace temblor::client
