#include "app/files/level_scene.h"

#include <charconv>
#include <optional>

#include "base/text.h"

namespace temblor::app {
namespace {

bool is_shown(std::string_view classname) {
  const std::string name = base::to_lower(classname);
  return !name.starts_with("trigger_") && name != "func_episodegate";
}

// N of "*N", where the level has that model and it is not the world.
std::optional<world::ModelIndex> brush_model_of(const world::Level& level, const formats::Entity& entity) {
  const std::string_view model = entity.find("model").value_or("");
  if (!model.starts_with('*')) return std::nullopt;
  std::uint32_t number = 0;
  const auto [end, failure] = std::from_chars(model.data() + 1, model.data() + model.size(), number);
  if (failure != std::errc{} || end != model.data() + model.size()) return std::nullopt;
  if (number == 0 || number >= level.models.size()) return std::nullopt;
  return static_cast<world::ModelIndex>(number);
}

}  // namespace

LevelScene make_level_scene(std::shared_ptr<const world::Level> level) {
  LevelScene scene;
  for (const formats::Entity& entity : level->entities) {
    const auto model = brush_model_of(*level, entity);
    if (!model || !is_shown(entity.classname())) continue;
    render::BrushModelInstance instance;
    instance.model = *model;
    instance.origin_world = entity.find_vec3("origin").value_or(math::Vec3(0.0f));
    scene.brush_models.push_back(instance);
  }
  scene.level = std::move(level);
  scene.light_styles = world::standard_light_styles();
  return scene;
}

render::Scene scene_at(const LevelScene& level_scene, const render::Camera& camera, double time_s) {
  render::Scene scene;
  scene.level = level_scene.level.get();
  scene.camera = camera;
  scene.brush_models = level_scene.brush_models;
  scene.time_s = time_s;
  scene.light_styles = world::light_style_values(level_scene.light_styles, time_s);
  return scene;
}

}  // namespace temblor::app
