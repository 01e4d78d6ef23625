#include "client/view/scene_choices.h"

#include <cmath>
#include <numbers>

#include "math/angles.h"
#include "world/trace.h"

namespace temblor::client {

SceneChoiceVariables::SceneChoiceVariables(command::Variables& variables) {
  const SceneChoices defaults;
  const ChaseCamera chase;
  const auto distance = [&](const char* name, float units, const char* help) {
    return variables.add_float(name, static_cast<double>(units), -1000, 1000, help);
  };
  entities_ = variables.add_bool("r_drawentities", defaults.entities, "Shows doors, monsters, and items.");
  particles_ = variables.add_int("r_particles", 1, 0, 2, "0: no particles; 1 or 2: particles.");
  dynamic_lights_ =
      variables.add_bool("r_dynamic", defaults.dynamic_lights, "Rockets and explosions light the level.");
  water_warp_ = variables.add_bool("r_waterwarp", defaults.warps_underwater, "Warps the view under water.");
  md5_models_ = variables.add_bool("r_md5", defaults.md5_models,
                                   "Draws the finer models of the 2021 release, where a game has them.");
  lock_pvs_ = variables.add_bool("r_lockpvs", defaults.locks_pvs,
                                 "Draws only what was visible from where you were when you set it to 1.");
  boxes_ = variables.add_bool("r_showbboxes", defaults.boxes,
                              "Shows the boxes with which entities collide, also through walls; alone only.");
  flat_light_styles_ =
      variables.add_int("r_flatlightstyles", 0, 0, 2,
                        "Lights do not flicker. 1: at their mean brightness, 2: at their highest.");
  chase_active_ = variables.add_bool("chase_active", false, "Shows the game from behind the player.");
  chase_back_ = distance("chase_back", chase.back, "How far the camera is behind the player, in units.");
  chase_up_ = distance("chase_up", chase.up, "How far the camera is above the player's eyes, in units.");
  chase_right_ = distance("chase_right", chase.right, "How far the camera is right of the player, in units.");
}

SceneChoices SceneChoiceVariables::read(const command::Variables& variables) const {
  const auto number = [&](command::VariableIndex index) {
    return static_cast<float>(variables.float_value(index));
  };
  SceneChoices choices;
  choices.entities = variables.bool_value(entities_);
  choices.particles = variables.int_value(particles_) != 0;
  choices.dynamic_lights = variables.bool_value(dynamic_lights_);
  choices.warps_underwater = variables.bool_value(water_warp_);
  choices.md5_models = variables.bool_value(md5_models_);
  choices.locks_pvs = variables.bool_value(lock_pvs_);
  choices.boxes = variables.bool_value(boxes_);
  choices.light_styles = static_cast<world::LightStyleMode>(variables.int_value(flat_light_styles_));
  if (variables.bool_value(chase_active_))
    choices.chase = ChaseCamera{number(chase_back_), number(chase_up_), number(chase_right_)};
  return choices;
}

void chase_player(const world::Level& level, const ChaseCamera& chase, PlayerView& io_view) {
  // How far the player sees, and how far the camera stays from walls.
  constexpr float kSight = 4096, kFromWall = 4;
  const auto trace = [&](const math::Vec3& from, const math::Vec3& to) {
    return world::trace_line(level, world::ModelIndex{0}, world::Hull::kPoint, from, to).end;
  };
  render::Camera& camera = io_view.camera;
  const math::Vec3 eye = camera.origin_world;
  const math::Basis look = math::basis_from_angles({camera.angles_deg.x, camera.angles_deg.y, 0});
  const math::Vec3 forward(look.forward), right(look.right);
  const math::Vec3 target = trace(eye, eye + forward * kSight);
  const math::Vec3 wanted = eye - forward * chase.back + right * chase.right + math::Vec3(0, 0, chase.up);
  const math::Vec3 reached = trace(eye, wanted);
  const float distance = glm::distance(eye, reached);
  if (distance <= kFromWall) return;
  camera.origin_world =
      reached == wanted ? reached : eye + (reached - eye) * ((distance - kFromWall) / distance);
  const math::Vec3 direction = target - camera.origin_world;
  const float along = std::hypot(direction.x, direction.y);
  camera.angles_deg.x = -std::atan2(direction.z, along) * 180 / std::numbers::pi_v<float>;
  camera.angles_deg.z = 0;
  io_view.show_weapon = false;
}

void apply_choices(const SceneChoices& choices, render::Scene& io_scene) {
  if (!choices.entities) {
    io_scene.brush_models = {};
    io_scene.alias_models = {};
    io_scene.sprites = {};
    io_scene.view_weapon = nullptr;
  }
  if (!choices.particles) io_scene.particles = {};
  if (!choices.dynamic_lights) io_scene.lights = {};
  if (!choices.warps_underwater) io_scene.underwater = false;
}

}  // namespace temblor::client
