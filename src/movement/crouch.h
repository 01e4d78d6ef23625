// The eyes of a player who crouches or stands up in a Half-Life level. They move within a fifth of a second.
// Server and client compute the same heights.
#pragma once

#include <algorithm>

namespace temblor::movement {

// Above the origin, in units. The lower eyes are as far above the feet as Half-Life's crouching player's.
constexpr float kStandingEyes = 22, kCrouchedEyes = 6;
constexpr float kEyeSpeed = (kStandingEyes - kCrouchedEyes) / 0.2f;  // units per second

// Whether crouching moves eyes of this height. Others belong to game code: those of the dead, for example.
constexpr bool is_crouching_height(float eyes_z) {
  return eyes_z >= kCrouchedEyes && eyes_z <= kStandingEyes;
}

// The height of such eyes after a tick.
inline float move_eyes(float eyes_z, bool is_crouching, float tick_s) {
  if (!is_crouching_height(eyes_z)) return eyes_z;
  const float wanted = is_crouching ? kCrouchedEyes : kStandingEyes;
  return std::clamp(wanted, eyes_z - kEyeSpeed * tick_s, eyes_z + kEyeSpeed * tick_s);
}

}  // namespace temblor::movement
