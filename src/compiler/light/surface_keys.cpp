#include "compiler/light/surface_keys.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string>
#include <string_view>

#include "base/text.h"
#include "compiler/light/sources/keys.h"
#include "compiler/light/sources/switchable_styles.h"

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

// Reads the textures of _minlight_exclude, _minlight_exclude2, and so on.
void read_excluded_textures(const formats::Entity& entity, SurfaceKeys& io_keys) {
  for (std::size_t i = 0; i < io_keys.min_light_excludes.size(); ++i) {
    const std::string number = i == 0 ? std::string() : std::to_string(i + 1);
    if (const auto texture = entity.find("_minlight_exclude" + number))
      io_keys.min_light_excludes[i] = make_texture_key(*texture);
  }
}

// Reads the keys about light that comes to the faces and leaves them.
void read_light_limits(const formats::Entity& entity, SurfaceKeys& io_keys) {
  const bool is_world = entity.classname() == "worldspawn";
  if (!is_world) {  // on worldspawn, these are settings for the whole level (sources/settings.h)
    io_keys.max_light = std::max(0.0f, read_number_or(entity, "maxlight", 0));
    io_keys.bounce_scale = std::max(0.0f, read_number_or(entity, "bouncescale", 1));
  }
  io_keys.light_color_scale = std::clamp(read_number_or(entity, "lightcolorscale", 1), 0.0f, 1.0f);
  io_keys.takes_light_behind = read_flag(entity, "light_twosided");
  // Other channels cast shadows for the lights of their own, and have no part in bounced light.
  io_keys.channels = read_channels(entity, "object_channel_mask").value_or(1);
  if (io_keys.channels == 1) return;
  io_keys.casts_shadow = io_keys.casts_shadow || read_number_or(entity, "shadow", 1) >= 0;
  io_keys.takes_bounce = false;
  io_keys.takes_dirt = io_keys.takes_dirt && (io_keys.channels & 1) != 0;
}

// A cut name would be another one, so longer names are none.
StyleName make_style_name(std::string_view name) {
  StyleName padded{};
  if (name.size() <= padded.size()) std::ranges::copy(name, padded.begin());
  return padded;
}

void read_surface_light_keys(const formats::Entity& entity, SurfaceKeys& io_keys) {
  constexpr float kMaxBrushGroup = 1 << 24, kMaxStyle = 63;
  io_keys.surface_light_group = static_cast<std::int32_t>(
      std::clamp(read_number_or(entity, "surflight_group", 0), -kMaxBrushGroup, kMaxBrushGroup));
  io_keys.surface_light_style =
      static_cast<std::int32_t>(std::clamp(read_number_or(entity, "surflight_style", -1), -1.0f, kMaxStyle));
  if (const auto color = read_color(entity, "surflight_color"))
    io_keys.surface_light_color = {color->x, color->y, color->z};
  io_keys.surface_light_rescale = read_flag(entity, "surflight_rescale");
  io_keys.surface_light_name = make_style_name(entity.find("_surflight_targetname").value_or(""));
}

}  // namespace

// Longer names do not exist in levels, so cut ones match nothing else.
TextureKey make_texture_key(std::string_view texture) {
  TextureKey key{};
  const std::string lower = base::to_lower(texture);
  std::copy_n(lower.begin(), std::min(lower.size(), key.size()), key.begin());
  return key;
}

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
  const auto color = read_color(entity, "minlight_color");
  if (const auto other = color ? color : read_color(entity, "mincolor"))
    keys.min_light_color = {other->x, other->y, other->z};
  keys.mottles_min_light = read_number_or(entity, "minlight_mottle",
                                          read_number_or(entity, "minlightMottle",
                                                         read_number_or(entity, "minlightmottle", 0))) > 0;
  read_excluded_textures(entity, keys);
  const bool shadow_unless_said = is_part_of_the_world(entity.classname());
  keys.casts_shadow = read_number_or(entity, "shadow", shadow_unless_said ? 1.0f : 0.0f) > 0;
  if (!keys.casts_shadow) {
    keys.shadows_own_model_only =
        read_number_or(entity, "shadowself", read_number_or(entity, "selfshadow", 0)) > 0;
    keys.shadows_world_only =
        !keys.shadows_own_model_only && read_number_or(entity, "shadowworldonly", 0) > 0;
    keys.casts_shadow = keys.shadows_own_model_only || keys.shadows_world_only;
  }
  keys.auto_min_light =
      static_cast<std::int8_t>(std::clamp(read_number_or(entity, "autominlight", 0), -1.0f, 1.0f));
  keys.takes_dirt = read_number_or(entity, "dirt", 0) >= 0;
  keys.takes_bounce = read_number_or(entity, "bounce", 0) >= 0;
  keys.ignores_light = read_number_or(entity, "lightignore", 0) > 0;
  keys.lights_liquids = read_lights_liquids(entity).value_or(true);
  // On worldspawn, _lightmap_scale is a number of texels (sources/settings.h).
  const bool is_world = entity.classname() == "worldspawn";
  const float scale =
      read_number_or(entity, "lmscale", is_world ? 1 : read_number_or(entity, "lightmap_scale", 1));
  keys.light_map_scale = scale > 0 ? scale : 1;
  keys.units_per_luxel = read_number_or(entity, "world_units_per_luxel", 0);
  const float alpha = read_number_or(entity, "light_alpha", read_number_or(entity, "alpha", 1));
  keys.light_alpha = std::clamp(alpha, 0.0f, 1.0f);
  read_light_limits(entity, keys);
  read_surface_light_keys(entity, keys);
  keys.shadow_name = make_style_name(find_brush_shadow_name(entity));
  keys.shadow_hides_leaves = keys.shadow_name != StyleName{} && entity.classname() == "func_group";
  return keys;
}

std::optional<bool> read_lights_liquids(const formats::Entity& entity) {
  for (const char* key : {"litwater", "splitturb"})
    if (const auto value = read_number(entity, key)) return *value > 0;
  return std::nullopt;
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
