// Brush models are lit where their entity's origin puts them when the level starts. Their vertices are copied
// there, so that their shadows fall where players first see them.
#include "compiler/light/lit_level.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string_view>
#include <utility>

#include "base/text.h"
#include "compiler/light/sources/switchable_styles.h"
#include "world/face_at.h"

namespace temblor::compiler {
namespace {

constexpr std::int32_t kFlagNoLight = 1;

// The number of the model that an entity shows ("model" "*3").
std::optional<std::size_t> find_shown_model(const formats::Entity& entity) {
  const std::string_view name = entity.find("model").value_or("");
  std::size_t number = 0;
  if (!name.starts_with('*')) return std::nullopt;
  const auto [end, error] = std::from_chars(name.data() + 1, name.data() + name.size(), number);
  return error == std::errc{} ? std::optional<std::size_t>(number) : std::nullopt;
}

// Textures of brushes that only the game uses.
bool is_never_drawn(std::string_view texture) {
  constexpr std::array<std::string_view, 6> kNames{"trigger", "clip", "skip", "hint", "hintskip", "origin"};
  return std::any_of(kNames.begin(), kNames.end(),
                     [&](std::string_view name) { return base::equal_ignoring_case(name, texture); });
}

// Sky, faces that are never drawn, and faces whose texinfo says so get no light.
bool may_be_lit(const world::Level& level, const world::Face& face, std::int32_t texinfo_flags) {
  const bool sky = level.texture(face.texture).kind == world::TextureKind::kSky;
  return !sky && !is_never_drawn(level.texture(face.texture).name) && (texinfo_flags & kFlagNoLight) == 0 &&
         face.surfedge_count >= 3;
}

constexpr std::size_t kHole = 255;  // the palette index that is not drawn

// The share of light that passes, by palette index. Glass tints light by its texels, the more the less
// transparent it is; without a palette it only dims light.
std::vector<math::Vec3> make_transmission_table(const SurfaceKeys& keys, bool has_holes,
                                                const std::optional<formats::Palette>& palette) {
  std::vector<math::Vec3> transmission(kHole + 1, math::Vec3(1 - keys.light_alpha));
  for (std::size_t i = 0; i < transmission.size() && palette && keys.light_alpha < 1; ++i) {
    const formats::Rgb& color = (*palette)[i];
    const math::Vec3 tint = math::Vec3(color.r, color.g, color.b) / 255.0f;
    transmission[i] = glm::mix(math::Vec3(1.0f), tint, keys.light_alpha);
  }
  if (has_holes) transmission[kHole] = math::Vec3(1.0f);
  return transmission;
}

ShadowReceivers find_shadow_receivers(const SurfaceKeys& keys) {
  if (keys.shadows_own_model_only) return ShadowReceivers::kOwnModel;
  return keys.shadows_world_only ? ShadowReceivers::kWorld : ShadowReceivers::kAll;
}

// The mask of a face with a transparent texture, _light_alpha, or a limited or switchable shadow.
AlphaMask make_alpha_mask(const LitLevel& lit, std::size_t number,
                          const std::optional<formats::Palette>& palette) {
  const world::Level& level = *lit.level;
  const world::Face& face = level.faces[number];
  const world::Texture& texture = level.texture(face.texture);
  const world::TextureAxes& axes = level.texture_axes[face.axes];
  const math::Vec3& offset = lit.model_offset(number);
  AlphaMask mask;
  mask.normal = math::Vec3(world::compute_face_plane(level, face).normal);
  mask.s_axis = axes.s_axis;
  mask.t_axis = axes.t_axis;
  mask.s_offset = axes.s_offset - glm::dot(offset, axes.s_axis);
  mask.t_offset = axes.t_offset - glm::dot(offset, axes.t_axis);
  mask.width = texture.width;
  mask.height = texture.height;
  const SurfaceKeys& keys = lit.surface_keys(number);
  const bool has_holes = texture.kind == world::TextureKind::kCutout;
  const bool has_texels = texture.mips[0].size() == std::size_t{texture.width} * texture.height;
  mask.texels = texture.mips[0];
  mask.transmission = math::Vec3(1 - keys.light_alpha);
  if (has_texels && (has_holes || keys.light_alpha < 1))
    mask.transmission_by_texel = make_transmission_table(keys, has_holes, palette);
  mask.model = lit.model_of_face[number];
  mask.receivers = find_shadow_receivers(keys);
  mask.channels = keys.channels;
  mask.switch_style = lit.switch_style(number);
  return mask;
}

// Adds a face as a triangle fan.
void add_fan(const LitLevel& lit, std::size_t number, std::uint32_t first_vertex, std::uint32_t surface,
             std::vector<OccluderTriangle>& io_triangles) {
  const world::Level& level = *lit.level;
  const world::Face& face = level.faces[number];
  const auto vertex = [&](std::uint32_t i) {
    return first_vertex + level.surfedge_start(std::size_t{face.first_surfedge} + i);
  };
  for (std::uint32_t i = 2; i < face.surfedge_count; ++i)
    io_triangles.push_back({{vertex(0), vertex(i - 1), vertex(i)}, surface});
}

// Sorts a face into the triangles that light meets; liquids and faces without shadow are left out.
void add_occluder(const LitLevel& lit, std::size_t number, std::uint32_t first_vertex,
                  const std::optional<formats::Palette>& palette, Occluders& io_occluders) {
  const world::Level& level = *lit.level;
  const world::Face& face = level.faces[number];
  const SurfaceKeys& keys = lit.surface_keys(number);
  const bool is_switchable = lit.switch_style(number) != 0;
  const world::TextureKind kind = level.texture(face.texture).kind;
  if (kind == world::TextureKind::kSky) {
    if (lit.model_of_face[number] != 0) return;
    const auto surface = static_cast<std::uint32_t>(io_occluders.sky_normals.size());
    io_occluders.sky_normals.emplace_back(world::compute_face_plane(level, face).normal);
    io_occluders.sky_names.push_back(static_cast<std::uint32_t>(base::to_size(face.texture)));
    add_fan(lit, number, first_vertex, surface, io_occluders.skies);
  } else if (kind == world::TextureKind::kLiquid || !(keys.casts_shadow || is_switchable)) {
    return;
  } else if (kind == world::TextureKind::kCutout || keys.light_alpha < 1 || keys.channels != 1 ||
             is_switchable || find_shadow_receivers(keys) != ShadowReceivers::kAll) {
    const auto surface = static_cast<std::uint32_t>(io_occluders.alpha_masks.size());
    io_occluders.alpha_masks.push_back(make_alpha_mask(lit, number, palette));
    add_fan(lit, number, first_vertex, surface, io_occluders.masked);
  } else {
    add_fan(lit, number, first_vertex, static_cast<std::uint32_t>(number), io_occluders.opaque);
  }
}

// Where a model's faces take their light from if they are hidden: the place of _autominlight_target, or the
// center of the model.
math::Vec3 find_center(const LitLevel& lit, std::size_t model, const formats::Entity& shown_by) {
  const world::Level& level = *lit.level;
  if (const auto target = shown_by.find("_autominlight_target"); target && !target->empty())
    for (const formats::Entity& entity : level.entities)
      if (const auto origin = entity.find_vec3("origin");
          origin && entity.find("targetname").value_or("") == *target)
        return *origin;
  const math::Bounds& bounds = level.models[model].bounds;
  return (bounds.mins + bounds.maxs) * 0.5f + lit.offset_of_model[model];
}

// Reads the entities that show models.
void read_models(LitLevel& io_lit) {
  const world::Level& level = *io_lit.level;
  io_lit.offset_of_model.assign(level.models.size(), math::Vec3(0.0f));
  io_lit.switch_style_of_model.assign(level.models.size(), 0);
  for (const world::Model& model : level.models)
    io_lit.center_of_model.push_back((model.bounds.mins + model.bounds.maxs) * 0.5f);
  for (const formats::Entity& entity : level.entities) {
    const auto model = find_shown_model(entity);
    if (!model || *model >= level.models.size()) continue;
    io_lit.offset_of_model[*model] = entity.find_vec3("origin").value_or(math::Vec3(0.0f));
    io_lit.center_of_model[*model] = find_center(io_lit, *model, entity);
    const float style = entity.find_number("switchshadstyle").value_or(0);
    if (has_switchable_shadow(entity) && style > 0 && style < 64)
      io_lit.switch_style_of_model[*model] = static_cast<std::uint8_t>(style);
  }
}

}  // namespace

bool LitLevel::takes_light_behind(std::size_t face) const {
  const std::int8_t asked = surface_keys(face).takes_light_behind;
  return asked < 0 ? level->texture(level->faces[face].texture).kind == world::TextureKind::kLiquid
                   : asked > 0;
}

std::vector<math::Vec3d> LitLevel::corners_world(std::size_t face) const {
  const world::Face& shape = level->faces[face];
  std::vector<math::Vec3d> corners;
  corners.reserve(shape.surfedge_count);
  for (std::uint32_t i = 0; i < shape.surfedge_count; ++i)
    corners.push_back(
        math::Vec3d(level->vertices[level->surfedge_start(std::size_t{shape.first_surfedge} + i)]) +
        math::Vec3d(model_offset(face)));
  return corners;
}

base::Result<LitLevel> make_lit_level(formats::Bsp bsp, FaceKeys keys) {
  CHECK(keys.of_face.size() == bsp.faces.size() && !keys.keys.empty());
  LitLevel lit;
  lit.keys = std::move(keys);
  lit.gets_light.resize(bsp.faces.size());
  std::vector<std::int32_t> texinfo_flags;
  texinfo_flags.reserve(bsp.faces.size());
  for (const formats::BspFace& face : bsp.faces) texinfo_flags.push_back(bsp.texinfos[face.texinfo].flags);
  TRY(lit.level, world::make_level(std::move(bsp), "level to light"));
  const world::Level& level = *lit.level;
  for (std::size_t i = 0; i < level.faces.size(); ++i)
    lit.gets_light[i] = may_be_lit(level, level.faces[i], texinfo_flags[i]);
  lit.model_of_face.assign(level.faces.size(), 0);
  for (std::size_t model = 1; model < level.models.size(); ++model) {
    const world::Model& faces = level.models[model];
    for (std::uint32_t i = 0; i < faces.face_count; ++i)
      lit.model_of_face[faces.first_face + i] = static_cast<std::uint32_t>(model);
  }
  read_models(lit);
  lit.styles_of_keys = find_brush_styles(level.entities, lit.keys);
  lit.maps = make_light_map_shapes(level, lit.keys, lit.gets_light, lit.too_fine_faces);
  return lit;
}

Occluders make_occluders(const LitLevel& lit, const std::optional<formats::Palette>& palette) {
  const world::Level& level = *lit.level;
  Occluders occluders;
  occluders.vertices = level.vertices;
  for (std::size_t model = 0; model < level.models.size(); ++model) {
    const world::Model& shape = level.models[model];
    std::uint32_t first_vertex = 0;
    // Vertices are shared within a model, so no light leaks between its faces.
    if (lit.offset_of_model[model] != math::Vec3(0.0f)) {
      first_vertex = static_cast<std::uint32_t>(occluders.vertices.size());
      for (const math::Vec3& vertex : level.vertices)
        occluders.vertices.push_back(vertex + lit.offset_of_model[model]);
    }
    for (std::uint32_t i = 0; i < shape.face_count; ++i)
      add_occluder(lit, std::size_t{shape.first_face} + i, first_vertex, palette, occluders);
  }
  return occluders;
}

}  // namespace temblor::compiler
