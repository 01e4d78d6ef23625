#include "world/loading/brush_entities.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>

namespace temblor::world {
namespace {

constexpr std::array<std::string_view, 4> kPassableClasses = {"func_illusionary", "func_water",
                                                              "func_door_rotating", "momentary_rot_door"};
// Values of "rendermode".
constexpr int kColorMode = 1, kAdditiveMode = 5;

// A missing or unreadable number is 0, as in Half-Life.
int read_number(const formats::Entity& entity, std::string_view key) {
  const std::string_view text = entity.find(key).value_or("");
  int number = 0;
  std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

// The number of a model "*NUMBER"; 0: the entity has none.
std::size_t find_model(const formats::Entity& entity) {
  const std::string_view name = entity.find("model").value_or("");
  std::size_t number = 0;
  if (name.starts_with('*')) std::from_chars(name.data() + 1, name.data() + name.size(), number);
  return number;
}

// "skin" is a liquid as BSP files number contents. Without it, the liquid is water.
Contents find_liquid(const formats::Entity& entity) {
  if (entity.classname() != "func_water") return Contents::kEmpty;
  const auto contents = static_cast<Contents>(read_number(entity, "skin"));
  return contents == Contents::kSlime || contents == Contents::kLava ? contents : Contents::kWater;
}

formats::Rgb find_color(const formats::Entity& entity) {
  const math::Vec3 color =
      glm::clamp(entity.find_vec3("rendercolor").value_or(math::Vec3(0.0f)), 0.0f, 255.0f);
  return {static_cast<std::uint8_t>(color.x), static_cast<std::uint8_t>(color.y),
          static_cast<std::uint8_t>(color.z)};
}

BrushEntity read_brush_entity(const formats::Entity& entity) {
  const int mode = read_number(entity, "rendermode");
  BrushEntity read;
  read.is_passable = std::ranges::find(kPassableClasses, entity.classname()) != kPassableClasses.end();
  read.liquid = find_liquid(entity);
  read.origin = entity.find_vec3("origin").value_or(math::Vec3(0.0f));
  read.is_additive = mode == kAdditiveMode;
  if (mode == kColorMode) read.color = find_color(entity);
  return read;
}

}  // namespace

std::vector<BrushEntity> read_brush_entities(std::span<const formats::Entity> entities,
                                             std::size_t model_count) {
  std::vector<BrushEntity> read(model_count);
  for (std::size_t i = entities.size(); i > 0; --i) {
    const std::size_t model = find_model(entities[i - 1]);
    if (model > 0 && model < model_count) read[model] = read_brush_entity(entities[i - 1]);
  }
  return read;
}

}  // namespace temblor::world
