#include "client/view/view.h"

#include <algorithm>

#include "client/session/powerups.h"
#include "math/angles.h"
#include "world/visibility.h"

namespace temblor::client {

namespace {

// The eye is kept off multiples of 1/16, so that it is never in the plane of a liquid's surface.
constexpr float kOffGrid = 1.0f / 32;
// The roll of a dead player's view, degrees.
constexpr float kDead_deg = 80;
// The share of the bob that moves the weapon forward.
constexpr float kWeaponAhead = 0.4f;

bool is_dead(const Game& game) {
  return game.data.health <= 0;
}

bool is_liquid(world::Contents contents) {
  return contents != world::Contents::kEmpty && contents != world::Contents::kSolid &&
         contents != world::Contents::kSky;
}

// Keeps the eye within the body's box; outside it, it could be in a wall. The limits are the original's.
math::Vec3 clamp_to_body(const math::Vec3& eye_world, const math::Vec3& body_world) {
  return glm::clamp(eye_world, body_world + math::Vec3(-14, -14, -22), body_world + math::Vec3(14, 14, 30));
}

render::Tint scale_tint(render::Tint tint, float factor) {
  tint.opacity = std::clamp(tint.opacity * factor, 0.0f, 1.0f);
  return tint;
}

// Whether a vector has become longer.
bool is_longer(const math::Vec3& now, const math::Vec3& before) {
  return glm::dot(now, now) > glm::dot(before, before);
}

}  // namespace

PlayerView make_camera_view(const render::Camera& camera, const world::Level& level,
                            const ViewSettings& settings) {
  PlayerView view;
  view.camera = camera;
  view.leaf = world::find_leaf(level, camera.origin_world);
  view.contents = world::point_contents(level, camera.origin_world);
  view.underwater = is_liquid(view.contents);
  view.tint = scale_tint(contents_tint(view.contents, settings.natural_liquids), settings.contents_tint);
  view.show_weapon = false;
  return view;
}

PlayerView View::advance(const Game& game, const Events& events, const ViewInput& input,
                         const ViewSettings& settings) {
  update(game, events, input);
  PlayerView view;
  view.camera.fov_deg = settings.fov_deg;
  if (game.ending != Ending::kNone)
    view_intermission(input, view);
  else
    view_from_eyes(game, input, settings, view);
  view.leaf = world::find_leaf(input.level, view.camera.origin_world);
  view.contents = world::point_contents(input.level, view.camera.origin_world, input.liquids);
  view.underwater = is_liquid(view.contents);
  view.tint = tint(game, view.contents, settings);
  return view;
}

void View::update(const Game& game, const Events& events, const ViewInput& input) {
  if (has_begun_ && input.time_s < last_time_s_) begin_level();
  const double elapsed_s = has_begun_ ? input.time_s - last_time_s_ : 0;
  update_place(input, input.own ? input.own->on_ground : game.data.on_ground, elapsed_s);
  // Acknowledged values change in steps and are eased; predicted ones are current.
  if (!has_begun_ || input.own)
    velocity_.jump(input.own ? input.own->velocity : game.data.velocity, input.time_s);
  else
    velocity_.advance(game.data.velocity, input.time_s);
  // A kick begins at once; only its fading comes in steps and is eased.
  if (is_longer(game.data.punch_deg, punch_deg_.value(input.time_s)))
    punch_deg_.jump(game.data.punch_deg, input.time_s);
  punch_deg_.advance(game.data.punch_deg, input.time_s);
  for (const net::Damage& damage : events.damages)
    kick_.add(damage, place_world_, input.view_angles_deg.y, input.time_s);
  fading_.advance(elapsed_s, events.damages, events.bonus_flashes);
  last_time_s_ = input.time_s;
  has_begun_ = true;
}

// Without a view entity in the packet, the last known place stays.
void View::update_place(const ViewInput& input, bool on_ground, double elapsed_s) {
  const math::Vec3 before_world = place_world_;
  if (input.view_entity) {
    place_world_ = input.view_entity->origin_world;
    place_angles_deg_ = input.view_entity->angles_deg;
  }
  if (input.own) place_world_ = input.own->origin_world;
  // A teleport is not a stair.
  constexpr float kJump = 100;
  if (!has_begun_ || glm::distance(before_world, place_world_) > kJump) stairs_.reset(place_world_.z);
  stair_offset_ = stairs_.advance(place_world_.z, on_ground, elapsed_s);
}

// After the level: the view is where the server puts it, swaying slowly, without bob or tints of the player.
void View::view_intermission(const ViewInput& input, PlayerView& io_view) const {
  io_view.camera.origin_world = place_world_;
  io_view.camera.angles_deg = place_angles_deg_ + compute_idle_sway_deg(input.time_s);
  io_view.show_weapon = false;
}

// During the level: through the player's eyes. The bob moves eyes and weapon up and down and the weapon
// forward as well; kicks and roll turn the head.
void View::view_from_eyes(const Game& game, const ViewInput& input, const ViewSettings& settings,
                          PlayerView& io_view) const {
  const math::Basis look = math::basis_from_angles(input.view_angles_deg);
  const math::Vec3 velocity = velocity_.value(input.time_s);
  const float bob = compute_bob(input.time_s, velocity, settings.bob_cycle_s, settings.bob_up) * settings.bob;
  const math::Vec3 up(0, 0, 1);
  const math::Vec3 stair_offset = up * stair_offset_;
  const float eyes_z =
      input.own ? input.own->crouching_eyes_z.value_or(game.data.view_height) : game.data.view_height;
  const math::Vec3 eye_world = place_world_ + up * (eyes_z + bob);

  math::Vec3 head_deg =
      input.view_angles_deg + kick_.angles_deg(input.time_s, settings.kick_s) * settings.kick;
  head_deg += compute_idle_sway_deg(input.time_s) * settings.idle_sway;
  head_deg.z += compute_strafe_roll_deg(velocity, math::Vec3(look.right)) * settings.roll;
  if (is_dead(game)) head_deg.z = kDead_deg;

  io_view.camera.origin_world = clamp_to_body(eye_world + kOffGrid, place_world_) + stair_offset;
  io_view.camera.angles_deg = head_deg + punch_deg_.value(input.time_s) * settings.shake;
  io_view.weapon_origin_world =
      eye_world + stair_offset + math::Vec3(look.forward) * (bob * kWeaponAhead) + up * settings.weapon_rise;
  // The punch of a shot moves the head but not the hands, and the hands do not lean.
  io_view.weapon_angles_deg = {-head_deg.x, head_deg.y, input.view_angles_deg.z};
  io_view.show_weapon = !is_dead(game) && (game.data.items & kItemInvisibility) == 0;
}

render::Tint View::tint(const Game& game, world::Contents contents, const ViewSettings& settings) const {
  render::Tint tint = scale_tint(contents_tint(contents, settings.natural_liquids), settings.contents_tint);
  if (contents == world::Contents::kEmpty) tint = settings.open_tint;
  if (game.ending != Ending::kNone) return tint;
  tint = blend_tints(tint, scale_tint(fading_.damage(), settings.damage_tint));
  tint = blend_tints(tint, scale_tint(fading_.bonus(), settings.bonus_tint));
  return blend_tints(tint, scale_tint(powerup_tint(game.data.items), settings.powerup_tint));
}

}  // namespace temblor::client
