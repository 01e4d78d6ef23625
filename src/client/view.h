// The player's eyes: where the camera is, what shakes it, what colours the view, and where the weapon is
// held.
#pragma once

#include <cstdint>
#include <span>

#include "client/client_state.h"
#include "client/seen_entity.h"
#include "render/scene.h"
#include "world/level.h"

namespace temblor::client {

// Factors, 1: as the original.
struct ViewSettings {
  float bob = 1, roll = 1, kick = 1;
  float damage_tint = 1, bonus_tint = 1, powerup_tint = 1, contents_tint = 1;
  float fov_deg = 90;
};

struct ViewMoment {
  double time_s;
  math::Vec3 view_angles_deg;     // where the player looks
  const SeenEntity* view_entity;  // null: it is not there; then the last place is kept
  const world::Level& level;
};

struct PlayerView {
  render::Camera camera;
  render::Tint tint;
  bool underwater = false;
  world::Contents contents = world::Contents::kEmpty;  // at the eye
  bool show_weapon = true;
  math::Vec3 weapon_origin_world{0.0f}, weapon_angles_deg{0.0f};
};

class View {
 public:
  void begin_level();
  PlayerView advance(const Game& game, const Events& events, const ViewMoment& moment,
                     const ViewSettings& settings);

 private:
  double last_time_s_ = 0;
  double damage_kick_until_s_ = 0;
  float kick_roll_deg_ = 0, kick_pitch_deg_ = 0;
  float damage_percent_ = 0, bonus_percent_ = 0;
  math::Vec3 damage_colour_{0.0f};
  float stair_z_ = 0;
  math::Vec3 last_origin_{0.0f};
};

}  // namespace temblor::client
