#include "compiler/light/surface_keys.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>

#include "compiler/light/sources/keys.h"

namespace temblor::compiler {
namespace {

// Whether the brushes of a class are part of the world and cast a shadow without being asked.
bool is_part_of_the_world(std::string_view classname) {
  return classname == "worldspawn" || classname == "func_group" ||
         (classname.starts_with("func_detail") && classname != "func_detail_illusionary");
}

std::optional<std::size_t> model_number(const formats::Entity& entity) {
  const std::string_view name = entity.find("model").value_or("");
  if (!name.starts_with('*')) return std::nullopt;
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(name.data() + 1, name.data() + name.size(), number);
  if (error != std::errc{} || end != name.data() + name.size()) return std::nullopt;
  return number;
}

}  // namespace

SurfaceKeys read_surface_keys(const formats::Entity& entity) {
  constexpr float kPhongDefaultAngleDeg = 89;
  SurfaceKeys keys;
  const float phong = read_number_or(entity, "phong", 0);
  keys.phong_angle_deg = read_number_or(entity, "phong_angle", phong > 0 ? kPhongDefaultAngleDeg : 0);
  keys.phong_angle_concave_deg = read_number_or(entity, "phong_angle_concave", 0);
  keys.phong_group =
      static_cast<std::int32_t>(std::clamp(read_number_or(entity, "phong_group", 0), -32768.0f, 32767.0f));
  // On worldspawn the key is a setting for the whole level (sources/settings.h).
  if (entity.classname() != "worldspawn") keys.min_light = read_number_or(entity, "minlight", 0);
  if (const auto color = read_color(entity, "minlight_color"))
    keys.min_light_color = {color->x, color->y, color->z};
  const bool shadow_unless_said = is_part_of_the_world(entity.classname());
  keys.casts_shadow = read_number_or(entity, "shadow", shadow_unless_said ? 1.0f : 0.0f) > 0;
  if (!keys.casts_shadow) {
    keys.shadows_own_model_only = read_number_or(entity, "shadowself", 0) > 0;
    keys.shadows_world_only =
        !keys.shadows_own_model_only && read_number_or(entity, "shadowworldonly", 0) > 0;
    keys.casts_shadow = keys.shadows_own_model_only || keys.shadows_world_only;
  }
  keys.auto_min_light =
      static_cast<std::int8_t>(std::clamp(read_number_or(entity, "autominlight", 0), -1.0f, 1.0f));
  keys.takes_dirt = read_number_or(entity, "dirt", 0) >= 0;
  keys.takes_bounce = read_number_or(entity, "bounce", 0) >= 0;
  keys.ignores_light = read_number_or(entity, "lightignore", 0) > 0;
  keys.lights_liquids = read_number_or(entity, "litwater", 0) > 0;
  const float scale = read_number_or(entity, "lmscale", read_number_or(entity, "lightmap_scale", 1));
  keys.light_map_scale = scale > 0 ? scale : 1;
  keys.units_per_luxel = read_number_or(entity, "world_units_per_luxel", 0);
  const float alpha = read_number_or(entity, "light_alpha", read_number_or(entity, "alpha", 1));
  keys.light_alpha = std::clamp(alpha, 0.0f, 1.0f);
  return keys;
}

// Entry 0 has the default keys, for faces of models that no entity shows.
FaceKeys find_face_keys(const formats::Bsp& bsp, std::span<const formats::Entity> entities) {
  FaceKeys result;
  result.keys.resize(1);
  result.of_face.assign(bsp.faces.size(), 0);
  for (const formats::Entity& entity : entities) {
    const bool world = entity.classname() == "worldspawn";
    const std::optional<std::size_t> model = world ? std::optional<std::size_t>(0) : model_number(entity);
    if (!model || *model >= bsp.models.size()) continue;
    const auto key = static_cast<std::uint32_t>(result.keys.size());
    result.keys.push_back(read_surface_keys(entity));
    const formats::BspModel& faces = bsp.models[*model];
    std::fill_n(result.of_face.begin() + faces.first_face, faces.face_count, key);
  }
  return result;
}

}  // namespace temblor::compiler
