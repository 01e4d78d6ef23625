#include "compiler/bsp/level_brushes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <string_view>

#include "base/text.h"
#include "compiler/bsp/brush_class.h"
#include "compiler/bsp/level_entities.h"
#include "compiler/surface_keys.h"
#include "compiler/texture_axes.h"

namespace temblor::compiler {
namespace {

using base::ErrorCode;

// What the name of a side's texture says of the brush.
enum class Special { kNone, kWater, kSlime, kLava, kSky, kClip, kSkip, kHint, kHintSkip, kOrigin };

Special special_of(std::string_view texture) {
  const std::string name = base::to_lower(texture);
  const auto begins = [&](std::string_view with) { return name.starts_with(with); };
  if (begins("*lava")) return Special::kLava;
  if (begins("*slime")) return Special::kSlime;
  if (begins("*")) return Special::kWater;
  if (begins("sky")) return Special::kSky;
  if (name == "clip") return Special::kClip;
  if (name == "hintskip") return Special::kHintSkip;
  if (begins("hint")) return Special::kHint;
  if (name == "origin") return Special::kOrigin;
  if (name == "skip" || name == "caulk" || name == "nodraw") return Special::kSkip;
  return Special::kNone;
}

bool is_drawn(std::string_view texture) {
  const Special special = special_of(texture);
  if (special == Special::kWater || special == Special::kSlime || special == Special::kLava)
    return !base::to_lower(texture).ends_with("skip");
  return special == Special::kNone || special == Special::kSky;
}

// The first side that says something decides; a hint brush is one with any hint.
Special special_of(const formats::MapBrush& brush) {
  Special found = Special::kNone;
  for (const formats::MapSide& side : brush.sides) {
    const Special special = special_of(side.texture);
    if (special == Special::kHint || special == Special::kOrigin) return special;
    if (found == Special::kNone && special != Special::kSkip && special != Special::kHintSkip)
      found = special;
  }
  return found;
}

Fill fill_of(Special special, const BrushClass& of_class) {
  switch (special) {
    case Special::kWater:
      return Fill::kWater;
    case Special::kSlime:
      return Fill::kSlime;
    case Special::kLava:
      return Fill::kLava;
    case Special::kSky:
      return Fill::kSky;
    case Special::kHint:
      return Fill::kEmpty;
    default:
      return of_class.solid;
  }
}

class Sorter {
 public:
  Sorter(const formats::Map& map, TextureSize texture_size, Warnings& io_warnings)
      : map_(map), texture_size_(texture_size), warnings_(io_warnings) {
    out_.models.emplace_back();
    out_.surface_keys.emplace_back();
  }

  base::Result<LevelBrushes> sort() {
    if (map_.entities.empty() || map_.entities.front().fields.classname() != "worldspawn")
      return base::error(ErrorCode::kMalformed, "the map has no worldspawn as its first entity");
    for (std::size_t i = 0; i < map_.entities.size(); ++i) TRY_STATUS(add_entity(i));
    if (out_.models.front().empty())
      return base::error(ErrorCode::kMalformed, "the world has no brush with a volume");
    return std::move(out_);
  }

 private:
  base::Status add_entity(std::size_t number) {
    const formats::MapEntity& entity = map_.entities[number];
    const std::string_view classname = entity.fields.classname();
    const BrushClass* const of_world = world_class(classname);
    if (of_world != nullptr) {
      std::vector<Brush> own;
      TRY_STATUS(add_brushes(number, *of_world, math::Vec3d(0.0), own));
      auto& world = out_.models.front();
      world.insert(world.end(), std::make_move_iterator(own.begin()), std::make_move_iterator(own.end()));
      out_.brush_entities.push_back({number == 0, {}, {}});
      return base::Ok{};
    }
    if (entity.brushes.empty()) {
      if (const auto origin = entity.fields.find_vec3("origin")) {
        out_.occupants_world.push_back(math::Vec3d(*origin));
        out_.entity_of_occupant.push_back(number);
      }
      return base::Ok{};
    }
    std::vector<Brush> brushes;
    const std::optional<math::Vec3d> pivot = origin_of_brushes(entity);
    TRY_STATUS(add_brushes(number, kModelClass, pivot.value_or(math::Vec3d(0.0)), brushes));
    if (brushes.empty()) {
      warnings_.push_back({"brush entity without brushes", fmt::format("entity {} ({})", number, classname)});
      out_.brush_entities.push_back({false, {}, {}});
      return base::Ok{};
    }
    out_.models.push_back(std::move(brushes));
    out_.brush_entities.push_back({true, fmt::format("*{}", out_.models.size() - 1),
                                   pivot ? fmt::format("{} {} {}", pivot->x, pivot->y, pivot->z) : ""});
    return base::Ok{};
  }

  // The middle of its brush textured "origin", about which it turns.
  std::optional<math::Vec3d> origin_of_brushes(const formats::MapEntity& entity) {
    for (const formats::MapBrush& brush : entity.brushes) {
      if (special_of(brush) != Special::kOrigin) continue;
      Warnings unused;
      PlaneSet planes;
      if (const auto solid = make_solid(brush, {}, math::Vec3d(0.0), planes, unused))
        return (solid->box.mins + solid->box.maxs) * 0.5;
    }
    return std::nullopt;
  }

  base::Status add_brushes(std::size_t entity_number, const BrushClass& of_class,
                           const math::Vec3d& origin_world, std::vector<Brush>& out) {
    const formats::MapEntity& entity = map_.entities[entity_number];
    const std::uint32_t keys = add_keys(entity.fields);
    for (std::size_t i = 0; i < entity.brushes.size(); ++i) {
      const formats::MapBrush& from = entity.brushes[i];
      const BrushPlace place{entity_number, i, from.line};
      const Special special = special_of(from);
      if (special == Special::kOrigin) continue;
      std::optional<BrushSolid> solid = make_solid(from, place, origin_world, out_.planes, warnings_);
      if (!solid) continue;
      Brush brush;
      brush.fill = fill_of(special, of_class);
      brush.is_detail = of_class.is_detail;
      brush.clips = brush.fill == Fill::kSolid || brush.fill == Fill::kDetail || brush.fill == Fill::kFence ||
                    brush.fill == Fill::kSky;
      brush.is_drawn = special != Special::kClip;

      brush.box = solid->box;
      for (std::size_t k = 0; k < solid->sides.size(); ++k) {
        BrushSide& side = solid->sides[k];
        const formats::MapSide& map_side = from.sides[solid->side_of[k]];
        if (is_drawn(map_side.texture))
          side.surface = add_surface(map_side, place, side.plane, origin_world, keys);
        side.splits = special != Special::kHint || special_of(map_side.texture) == Special::kHint;
      }
      brush.sides = std::move(solid->sides);
      out.push_back(std::move(brush));
    }
    return base::Ok{};
  }

  std::uint32_t add_keys(const formats::Entity& fields) {
    const SurfaceKeys keys = surface_keys_of(fields);
    const auto known = std::find(out_.surface_keys.begin(), out_.surface_keys.end(), keys);
    if (known != out_.surface_keys.end())
      return static_cast<std::uint32_t>(known - out_.surface_keys.begin());
    out_.surface_keys.push_back(keys);
    return static_cast<std::uint32_t>(out_.surface_keys.size() - 1);
  }

  std::uint32_t add_surface(const formats::MapSide& side, const BrushPlace& place, PlaneIndex plane,
                            const math::Vec3d& origin_world, std::uint32_t keys) {
    Surface surface;
    const SideAxes found = side_axes(side.texturing, out_.planes[plane].normal, texture_size_(side.texture));
    if (found.replaced)
      warnings_.push_back({"texture axes that do not lie on the side",
                           describe(place) + fmt::format(", side in line {}", side.line)});
    // The brush was moved, and its texture with it.
    TextureAxes axes = found.axes;
    axes.s_offset += glm::dot(origin_world, axes.s_axis);
    axes.t_offset += glm::dot(origin_world, axes.t_axis);
    surface.texinfo = to_texinfo(axes, add_texture(side.texture),
                                 special_of(side.texture) == Special::kNone ? 0 : kUnlitTexinfo);
    surface.keys = keys;
    const std::array<float, 8> key = {surface.texinfo.s_axis.x, surface.texinfo.s_axis.y,
                                      surface.texinfo.s_axis.z, surface.texinfo.s_offset,
                                      surface.texinfo.t_axis.x, surface.texinfo.t_axis.y,
                                      surface.texinfo.t_axis.z, surface.texinfo.t_offset};
    const auto [known, is_new] = surfaces_.try_emplace({key, surface.texinfo.miptex, keys},
                                                       static_cast<std::uint32_t>(out_.surfaces.size()));
    if (is_new) out_.surfaces.push_back(surface);
    return known->second;
  }

  std::int32_t add_texture(const std::string& name) {
    const auto [known, is_new] =
        textures_.try_emplace(base::to_lower(name), static_cast<std::int32_t>(out_.textures.size()));
    if (is_new) out_.textures.push_back(name);
    return known->second;
  }

  const formats::Map& map_;
  TextureSize texture_size_;

  Warnings& warnings_;
  LevelBrushes out_;

  std::map<std::string, std::int32_t> textures_;
  std::map<std::tuple<std::array<float, 8>, std::int32_t, std::uint32_t>, std::uint32_t> surfaces_;
};

}  // namespace

base::Result<LevelBrushes> sort_brushes(const formats::Map& map, TextureSize texture_size,
                                        Warnings& io_warnings) {
  return Sorter(map, texture_size, io_warnings).sort();
}

}  // namespace temblor::compiler
