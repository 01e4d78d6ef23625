// Color tints over the view: liquids, pain, pickups, power-ups. All are combined into one color with the
// effect of blending them over the picture one after the other. Colors and strengths are the original's.
// Stock Quake changed the video palette for the same effect.
#pragma once

#include <span>

#include "net/protocol/server_message.h"
#include "render/tint.h"
#include "world/level.h"

namespace temblor::client {

// The combination of two tints: `above` over `below`.
render::Tint blend_tints(const render::Tint& below, const render::Tint& above);

// The tint of an eye in these contents; clear in the open. The original's water is brown; `natural` water is
// blue, and slime is green.
render::Tint contents_tint(world::Contents contents, bool natural = false);
// The tint of the first of quad, suit, ring and pentagram among the items.
render::Tint powerup_tint(std::uint32_t items);

// The tints that fade: damage and pickups. Percentages are added by each hit and fall at a constant rate.
class FadingTints {
 public:
  // Fades for `elapsed_s`, then adds what happened at the end of that time.
  void advance(double elapsed_s, std::span<const net::Damage> damages, int bonus_flashes);
  render::Tint damage() const;
  render::Tint bonus() const;

 private:
  float damage_percent_ = 0, bonus_percent_ = 0;  // of 256, as in the original
  math::Vec3 damage_color_{0.0f};
};

}  // namespace temblor::client
