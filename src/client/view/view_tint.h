// Colors over the view: what the eye is in, pain, things picked up, power-ups. One color comes out that
// does what laying them over the picture one after the other would.
#pragma once

#include <span>

#include "net/protocol/server_message.h"
#include "render/scene.h"
#include "world/level.h"

namespace temblor::client {

// Laying `above` over what has `below` over it already.
render::Tint tint_over(const render::Tint& below, const render::Tint& above);

// Of an eye in there; clear in the open.
render::Tint contents_tint(world::Contents contents);
// Of the first of quad, suit, ring and pentagram that is among the items.
render::Tint powerup_tint(std::uint32_t items);

// The tints that fade.
class FadingTints {
 public:
  // Lets `passed_s` go by, then takes what happened at its end.
  void advance(double passed_s, std::span<const net::Damage> damages, int bonus_flashes);
  render::Tint damage() const;
  render::Tint bonus() const;

 private:
  float damage_percent_ = 0, bonus_percent_ = 0;  // of 256, as the original counts
  math::Vec3 damage_color_{0.0f};
};

}  // namespace temblor::client
