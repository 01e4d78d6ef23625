#include "app/level/level_scene.h"

#include <charconv>
#include <optional>

#include "base/text.h"
#include "world/entity_opacity.h"

namespace temblor::app {
namespace {

// Triggers are removed or invisible in the game. A func_episodegate appears only after its episode is
// finished.
bool is_shown(std::string_view classname) {
  const std::string name = base::to_lower(classname);
  return !name.starts_with("trigger_") && name != "func_episodegate";
}

// Returns N for a model "*N"; nothing if the level has no such model, or if it is the world.
std::optional<world::ModelIndex> find_brush_model(const world::Level& level, const formats::Entity& entity) {
  const std::string_view model = entity.find("model").value_or("");
  if (!model.starts_with('*')) return std::nullopt;
  std::uint32_t number = 0;
  const auto [end, failure] = std::from_chars(model.data() + 1, model.data() + model.size(), number);
  if (failure != std::errc{} || end != model.data() + model.size()) return std::nullopt;
  if (number == 0 || number >= level.models.size()) return std::nullopt;
  return static_cast<world::ModelIndex>(number);
}

// A light that triggers switch has a light style of its own, which game code sets: to normal light, or to
// none if the light starts off.
void apply_switched_light(const formats::Entity& entity, world::LightStylePatterns& io_styles) {
  constexpr float kFirstSwitched = 32;
  constexpr int kStartsOff = 1;
  const float style = entity.find_number("style").value_or(0);
  if (!entity.classname().starts_with("light") || !entity.find("targetname") || !(style >= kFirstSwitched) ||
      !(style < static_cast<float>(io_styles.size())))
    return;
  const bool is_off = (world::spawn_flags(entity) & kStartsOff) != 0;
  io_styles[static_cast<std::size_t>(style)] = is_off ? "a" : "m";
}

}  // namespace

// Moving parts are drawn where the editor placed them, because no game code runs that could move them.
LevelScene make_level_scene(std::shared_ptr<const world::Level> level, const world::SpawnRules& rules) {
  LevelScene scene;
  scene.light_styles = world::make_standard_light_styles();
  for (const formats::Entity& entity : level->entities) {
    if (world::is_excluded(entity, rules)) continue;
    apply_switched_light(entity, scene.light_styles);
    const auto model = find_brush_model(*level, entity);
    const float opacity = world::find_opacity(entity, level->is_half_life);
    if (!model || !is_shown(entity.classname()) || opacity == 0) continue;
    render::BrushModelInstance instance;
    instance.model = *model;
    instance.origin_world = entity.find_vec3("origin").value_or(math::Vec3(0.0f));
    instance.alpha = opacity;
    if (level->is_half_life) {
      const world::BrushEntity& keys = level->brush_entities[base::to_size(*model)];
      instance.is_additive = keys.is_additive;
      instance.color = keys.color;
    }
    scene.brush_models.push_back(instance);
  }
  scene.level = std::move(level);
  return scene;
}

render::Scene make_scene(const LevelScene& level_scene, const render::Camera& camera, double time_s,
                         world::LightStyleMode light_styles) {
  render::Scene scene;
  scene.level = level_scene.level.get();
  scene.camera = camera;
  scene.brush_models = level_scene.brush_models;
  scene.time_s = time_s;
  scene.light_styles = world::compute_light_styles(level_scene.light_styles, time_s, light_styles);
  return scene;
}

}  // namespace temblor::app
