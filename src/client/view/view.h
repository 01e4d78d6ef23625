// The player's eyes: where the camera is, what shakes it, what colors the view, and where the weapon is
// held.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "client/session/client_state.h"
#include "client/session/seen_entity.h"
#include "client/view/view_motion.h"
#include "client/view/view_tint.h"
#include "render/scene.h"
#include "world/level.h"

namespace temblor::client {

// Factors, 1: as the original.
struct ViewSettings {
  float bob = 1, roll = 1, kick = 1;
  float damage_tint = 1, bonus_tint = 1, powerup_tint = 1, contents_tint = 1;
  float fov_deg = 90;
  // Units by which the weapon is held higher, to stand clear of the status bar: the original's 2 above its
  // whole bar, 1 above the small one, 0 without.
  float weapon_rise = 2;
};

// The player's own place as it is shown, where that is not what the server's last word says.
struct OwnMotion {
  math::Vec3 origin_world{0.0f}, velocity{0.0f};
  bool on_ground = false;
};

struct ViewMoment {
  double time_s;
  math::Vec3 view_angles_deg;     // where the player looks
  const SeenEntity* view_entity;  // null: it is not there; then the last place is kept
  const world::Level& level;
  std::optional<OwnMotion> own{};  // in place of the view entity's origin and of the update's velocity
};

struct PlayerView {
  render::Camera camera;
  render::Tint tint;
  bool underwater = false;
  world::LeafIndex leaf{};                             // that the eye is in
  world::Contents contents = world::Contents::kEmpty;  // at the eye
  bool show_weapon = true;
  math::Vec3 weapon_origin_world{0.0f};
  math::Vec3 weapon_angles_deg{0.0f};  // pitch is positive upwards, as alias models have it
};

// What is to be seen from anywhere else, by nobody.
PlayerView view_from(const render::Camera& camera, const world::Level& level, const ViewSettings& settings);

class View {
 public:
  void begin_level() { *this = {}; }
  // What is to be seen at `moment`, after `events`. Time must not run backwards; if it does (a demo rewound),
  // whatever was fading has ended.
  PlayerView advance(const Game& game, const Events& events, const ViewMoment& moment,
                     const ViewSettings& settings);

 private:
  void follow(const Game& game, const Events& events, const ViewMoment& moment);
  void follow_place(const ViewMoment& moment, bool on_ground, double passed_s);
  void look_on(const ViewMoment& moment, PlayerView& io_view) const;
  void look_out(const Game& game, const ViewMoment& moment, const ViewSettings& settings,
                PlayerView& io_view) const;
  render::Tint tint(const Game& game, world::Contents contents, const ViewSettings& settings) const;

  double last_time_s_ = 0;
  bool begun_ = false;
  math::Vec3 place_world_{0.0f}, place_angles_deg_{0.0f};  // of the view entity, when last seen
  float stairs_behind_ = 0;
  StairSmoothing stairs_;
  DamageKick kick_;
  EasedVector velocity_, punch_deg_;
  FadingTints fading_;
};

}  // namespace temblor::client
