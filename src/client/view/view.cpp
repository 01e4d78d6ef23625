#include "client/view/view.h"

#include <algorithm>

#include "client/session/powerups.h"
#include "math/angles.h"
#include "world/visibility.h"

namespace temblor::client {

namespace {

// The eye stands off every multiple of 1/16, so that it never lies in the plane of a liquid's surface.
constexpr float kOffGrid = 1.0f / 32;
constexpr float kDead_deg = 80;
constexpr float kWeaponAhead = 0.4f;  // of the bob

bool is_dead(const Game& game) {
  return game.data.health <= 0;
}

bool is_liquid(world::Contents contents) {
  return contents != world::Contents::kEmpty && contents != world::Contents::kSolid &&
         contents != world::Contents::kSky;
}

// Not out of the body's box, where the eye could be in a wall.
math::Vec3 within_body(const math::Vec3& eye_world, const math::Vec3& body_world) {
  return glm::clamp(eye_world, body_world + math::Vec3(-14, -14, -22), body_world + math::Vec3(14, 14, 30));
}

render::Tint scaled(render::Tint tint, float factor) {
  tint.opacity = std::clamp(tint.opacity * factor, 0.0f, 1.0f);
  return tint;
}

bool grows(const math::Vec3& now, const math::Vec3& before) {
  return glm::dot(now, now) > glm::dot(before, before);
}

}  // namespace

PlayerView view_from(const render::Camera& camera, const world::Level& level, const ViewSettings& settings) {
  PlayerView view;
  view.camera = camera;
  view.leaf = world::find_leaf(level, camera.origin_world);
  view.contents = level.leaf(view.leaf).contents;
  view.underwater = is_liquid(view.contents);
  view.tint = scaled(contents_tint(view.contents), settings.contents_tint);
  view.show_weapon = false;
  return view;
}

PlayerView View::advance(const Game& game, const Events& events, const ViewMoment& moment,
                         const ViewSettings& settings) {
  follow(game, events, moment);
  PlayerView view;
  view.camera.fov_deg = settings.fov_deg;
  if (game.ending != Ending::kNone)
    look_on(moment, view);
  else
    look_out(game, moment, settings, view);
  view.leaf = world::find_leaf(moment.level, view.camera.origin_world);
  view.contents = moment.level.leaf(view.leaf).contents;
  view.underwater = is_liquid(view.contents);
  view.tint = tint(game, view.contents, settings);
  return view;
}

void View::follow(const Game& game, const Events& events, const ViewMoment& moment) {
  if (begun_ && moment.time_s < last_time_s_) begin_level();
  const double passed_s = begun_ ? moment.time_s - last_time_s_ : 0;
  follow_place(moment, moment.own ? moment.own->on_ground : game.data.on_ground, passed_s);
  // What is told comes in steps; what is predicted is of this moment.
  if (!begun_ || moment.own)
    velocity_.jump(moment.own ? moment.own->velocity : game.data.velocity, moment.time_s);
  else
    velocity_.advance(game.data.velocity, moment.time_s);
  // A kick is felt at once; it is its fading that comes in steps.
  if (grows(game.data.punch_deg, punch_deg_.value(moment.time_s)))
    punch_deg_.jump(game.data.punch_deg, moment.time_s);
  punch_deg_.advance(game.data.punch_deg, moment.time_s);
  for (const net::Damage& damage : events.damages)
    kick_.take(damage, place_world_, moment.view_angles_deg.y, moment.time_s);
  fading_.advance(passed_s, events.damages, events.bonus_flashes);
  last_time_s_ = moment.time_s;
  begun_ = true;
}

void View::follow_place(const ViewMoment& moment, bool on_ground, double passed_s) {
  const math::Vec3 before_world = place_world_;
  if (moment.view_entity) {
    place_world_ = moment.view_entity->origin_world;
    place_angles_deg_ = moment.view_entity->angles_deg;
  }
  if (moment.own) place_world_ = moment.own->origin_world;
  // Through a teleporter nobody climbs.
  constexpr float kJump = 100;
  if (!begun_ || glm::distance(before_world, place_world_) > kJump) stairs_.follow(place_world_.z);
  stairs_behind_ = stairs_.advance(place_world_.z, on_ground, passed_s);
}

// When the level is over: from where the server puts the view.
void View::look_on(const ViewMoment& moment, PlayerView& io_view) const {
  io_view.camera.origin_world = place_world_;
  io_view.camera.angles_deg = place_angles_deg_ + idle_sway_deg(moment.time_s);
  io_view.show_weapon = false;
}

// Out of the player's eyes.
void View::look_out(const Game& game, const ViewMoment& moment, const ViewSettings& settings,
                    PlayerView& io_view) const {
  const math::Basis look = math::basis_from_angles(moment.view_angles_deg);
  const math::Vec3 velocity = velocity_.value(moment.time_s);
  const float bob = bob_units(moment.time_s, velocity) * settings.bob;
  const math::Vec3 up(0, 0, 1);
  const math::Vec3 behind = up * stairs_behind_;
  const math::Vec3 eye_world = place_world_ + up * (game.data.view_height + bob);

  math::Vec3 head_deg = moment.view_angles_deg + kick_.angles_deg(moment.time_s) * settings.kick;
  head_deg.z += strafe_roll_deg(velocity, math::Vec3(look.right)) * settings.roll;
  if (is_dead(game)) head_deg.z = kDead_deg;

  io_view.camera.origin_world = within_body(eye_world + kOffGrid, place_world_) + behind;
  io_view.camera.angles_deg = head_deg + punch_deg_.value(moment.time_s) * settings.kick;
  io_view.weapon_origin_world =
      eye_world + behind + math::Vec3(look.forward) * (bob * kWeaponAhead) + up * settings.weapon_rise;
  // A shot's punch moves the head, not the hands; the hands do not lean.
  io_view.weapon_angles_deg = {-head_deg.x, head_deg.y, moment.view_angles_deg.z};
  io_view.show_weapon = !is_dead(game) && (game.data.items & kItemInvisibility) == 0;
}

render::Tint View::tint(const Game& game, world::Contents contents, const ViewSettings& settings) const {
  render::Tint tint = scaled(contents_tint(contents), settings.contents_tint);
  if (game.ending != Ending::kNone) return tint;
  tint = tint_over(tint, scaled(fading_.damage(), settings.damage_tint));
  tint = tint_over(tint, scaled(fading_.bonus(), settings.bonus_tint));
  return tint_over(tint, scaled(powerup_tint(game.data.items), settings.powerup_tint));
}

}  // namespace temblor::client
