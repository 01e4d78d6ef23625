// The player's view: where the camera is, what shakes it, what tints it, and where the weapon is held.
//
//   view entity or prediction -> origin + eye height + bob + stairs   -> camera, weapon
//   view angles               -> + kick + roll + punch               -> camera
//   contents, damage, items   -> tints                                -> one tint over the picture
//
// It looks like the original's view, but is a function of time rather than of frames.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "client/session/client_state.h"
#include "client/session/interpolated_entity.h"
#include "client/view/view_motion.h"
#include "client/view/view_tint.h"
#include "render/scene.h"
#include "world/level.h"
#include "world/visibility.h"

namespace temblor::client {

// Factors on the strength of each effect; 1 is the original's strength.
struct ViewSettings {
  float bob = 1, roll = 1, kick = 1;
  double bob_cycle_s = 0.6, bob_up = 0.5;  // see compute_bob()
  float shake = 1;                         // of recoil and blasts, which the server sends
  double kick_s = 0.5;                     // how long damage shakes the view
  float idle_sway = 0;                     // the original's strength during an intermission is 1
  float damage_tint = 1, bonus_tint = 1, powerup_tint = 1, contents_tint = 1;
  bool natural_liquids = false;  // see contents_tint()
  render::Tint open_tint{};      // of the view in the open, from the server
  float fov_deg = 90;
  // How much higher the weapon is held, to clear the status bar: in the original 2 units above the full bar,
  // 1 above the small one, 0 without.
  float weapon_rise = 2;
};

// The player's own motion as predicted, which is ahead of the server's last packet.
struct PredictedMotion {
  math::Vec3 origin_world{0.0f}, velocity{0.0f};
  bool on_ground = false;
  // The eyes' height above the origin where players can crouch; otherwise the server's counts.
  std::optional<float> crouching_eyes_z{};
};

// The inputs of a frame.
struct ViewInput {
  // On the server's clock.
  double time_s;
  // Where the player looks.
  math::Vec3 view_angles_deg;
  // Null if it does not exist; the view then stays.
  const InterpolatedEntity* view_entity;
  const world::Level& level;
  // Replaces the view entity's origin and the packet's velocity.
  std::optional<PredictedMotion> own{};
  std::span<const world::PlacedLiquid> liquids{};
};

// The view of a frame.
struct PlayerView {
  render::Camera camera;
  render::Tint tint;
  bool underwater = false;
  // The leaf that the eye is in.
  world::LeafIndex leaf{};
  world::Contents contents = world::Contents::kEmpty;  // at the eye
  bool show_weapon = true;
  math::Vec3 weapon_origin_world{0.0f};
  // Pitch is positive upward, as in alias models.
  math::Vec3 weapon_angles_deg{0.0f};
};

// The view from a camera that is not the player's: without weapon, and tinted only by liquids.
PlayerView make_camera_view(const render::Camera& camera, const world::Level& level,
                            const ViewSettings& settings);

// Tracks the effects that fade or are eased from frame to frame.
class View {
 public:
  void begin_level() { *this = {}; }
  // Advances to `input` and returns its view, after `events`. If time runs backward (a demo was rewound), all
  // fading effects end.
  PlayerView advance(const Game& game, const Events& events, const ViewInput& input,
                     const ViewSettings& settings);

 private:
  void update(const Game& game, const Events& events, const ViewInput& input);
  void update_place(const ViewInput& input, bool on_ground, double elapsed_s);
  void view_intermission(const ViewInput& input, PlayerView& io_view) const;
  void view_from_eyes(const Game& game, const ViewInput& input, const ViewSettings& settings,
                      PlayerView& io_view) const;
  render::Tint tint(const Game& game, world::Contents contents, const ViewSettings& settings) const;

  double last_time_s_ = 0;
  bool has_begun_ = false;
  math::Vec3 place_world_{0.0f}, place_angles_deg_{0.0f};  // of the view entity, last known
  float stair_offset_ = 0;
  StairSmoothing stairs_;
  DamageKick kick_;
  EasedVector velocity_, punch_deg_;
  FadingTints fading_;
};

}  // namespace temblor::client
