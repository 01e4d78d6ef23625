#include "client/fog_fade.h"

#include <algorithm>

namespace temblor::client {

void FogFade::follow(const net::Fog& fog, double since_s) {
  if (since_s == since_s_) return;
  from_ = at(since_s);
  to_ = {fog.density, fog.colour};
  since_s_ = since_s;
  fade_s_ = std::max(0.0, static_cast<double>(fog.fade_s));
}

render::Fog FogFade::at(double time_s) const {
  if (fade_s_ <= 0) return to_;
  const auto done = static_cast<float>(std::clamp((time_s - since_s_) / fade_s_, 0.0, 1.0));
  return {from_.density + (to_.density - from_.density) * done, glm::mix(from_.colour, to_.colour, done)};
}

}  // namespace temblor::client
