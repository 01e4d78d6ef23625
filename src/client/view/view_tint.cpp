#include "client/view/view_tint.h"

#include <algorithm>

#include "client/session/powerups.h"

namespace temblor::client {

namespace {

constexpr float kWhole = 256;

// Colors in the original's units: 0 to 255, and the opacity in parts of 256.
constexpr render::Tint tint(float red, float green, float blue, float part) {
  return {{red, green, blue}, part / kWhole};
}

// The strength of a hit, as for the view's kick.
float compute_damage_count(const net::Damage& damage) {
  return std::max(10.0f, static_cast<float>(damage.armor + damage.blood) / 2);
}

// Pale if armor took most of the damage, red without armor.
math::Vec3 damage_color(const net::Damage& damage) {
  if (damage.armor > damage.blood) return {200, 100, 100};
  if (damage.armor > 0) return {220, 50, 50};
  return {255, 0, 0};
}

}  // namespace

// Two blends c' = c (1 - a) + t a in a row are one blend: with opacity a = a1 (1 - a2) + a2 and color (t1 a1
// (1 - a2) + t2 a2) / a.
render::Tint blend_tints(const render::Tint& below, const render::Tint& above) {
  const float below_seen = below.opacity * (1 - above.opacity);
  const float opacity = below_seen + above.opacity;
  if (!(opacity > 0)) return {};
  return {(below.color * below_seen + above.color * above.opacity) / opacity, opacity};
}

render::Tint contents_tint(world::Contents contents, bool natural) {
  switch (contents) {
    case world::Contents::kEmpty:
    case world::Contents::kSolid:
    case world::Contents::kSky:
      return {};
    case world::Contents::kLava:
      return tint(255, 80, 0, 150);
    case world::Contents::kSlime:
      return natural ? tint(46, 96, 10, 140) : tint(0, 25, 5, 150);
    default:
      return natural ? tint(20, 78, 130, 110) : tint(130, 80, 50, 128);
  }
}

render::Tint powerup_tint(std::uint32_t items) {
  if (items & kItemQuad) return tint(0, 0, 255, 30);
  if (items & kItemSuit) return tint(0, 255, 0, 20);
  if (items & kItemInvisibility) return tint(100, 100, 100, 100);
  if (items & kItemInvulnerability) return tint(255, 255, 0, 30);
  return {};
}

void FadingTints::advance(double elapsed_s, std::span<const net::Damage> damages, int bonus_flashes) {
  constexpr float kDamageFades = 150, kBonusFades = 100;  // percent of 256 per second
  constexpr float kMaxDamage = 150, kBonus = 50;
  const auto passed = static_cast<float>(elapsed_s);
  damage_percent_ = std::max(0.0f, damage_percent_ - kDamageFades * passed);
  bonus_percent_ = std::max(0.0f, bonus_percent_ - kBonusFades * passed);
  for (const net::Damage& damage : damages) {
    damage_percent_ = std::min(kMaxDamage, damage_percent_ + 3 * compute_damage_count(damage));
    damage_color_ = damage_color(damage);
  }
  if (bonus_flashes > 0) bonus_percent_ = kBonus;
}

render::Tint FadingTints::damage() const {
  return {damage_color_, damage_percent_ / kWhole};
}

render::Tint FadingTints::bonus() const {
  return {{215, 186, 69}, bonus_percent_ / kWhole};
}

}  // namespace temblor::client
