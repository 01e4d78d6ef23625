#include "compiler/bsp/brushes/level_brushes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <string_view>
#include <tuple>

#include "base/text.h"
#include "compiler/bsp/brushes/brush_class.h"
#include "compiler/bsp/brushes/key_values.h"
#include "compiler/bsp/brushes/level_entities.h"
#include "compiler/bsp/brushes/region.h"
#include "compiler/build/surface_keys.h"
#include "compiler/light/sources/keys.h"
#include "compiler/textures/texture_axes.h"

namespace temblor::compiler {
namespace {

// Lit faces are cut every 240 texels: a side must not become more than some ten thousand of them.
bool stretch_to_fit(const Winding& winding, math::Vec3d& io_axis, double& io_offset) {
  constexpr double kMaxTexels = 240 * 128;
  double least = 1e30, most = -1e30;
  for (const math::Vec3d& point : winding) {
    least = std::min(least, glm::dot(point, io_axis));
    most = std::max(most, glm::dot(point, io_axis));
  }
  if (most - least <= kMaxTexels) return false;
  const double scale = kMaxTexels / (most - least);
  io_axis *= scale;
  io_offset *= scale;
  return true;
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
      return base::malformed("the map has no worldspawn as its first entity");
    TRY(region_, find_region(map_, warnings_));
    for (std::size_t i = 0; i < map_.entities.size(); ++i) add_entity(i);
    out_.is_region = region_.has_value();
    if (region_) close_region();
    for (std::vector<Brush>& brushes : out_.models) std::ranges::stable_sort(brushes, {}, &Brush::chop_order);
    if (out_.models.front().empty()) return base::malformed("the world has no brush with a volume");
    warn_without_start();
    warn_of_unreadable_values(map_, warnings_);
    return std::move(out_);
  }

 private:
  void add_entity(std::size_t number) {
    const formats::MapEntity& entity = map_.entities[number];
    if (const BrushClass of_class = brush_class_of(entity.fields); of_class.is_world) {
      add_brushes(number, of_class, math::Vec3d(0.0), out_.models.front());
      add_fields(entity.fields, {number == 0, {}, {}});
      if (number > 0 && entity.fields.classname() == "worldspawn")
        warnings_.push_back({"a second worldspawn, of which only brushes are taken",
                             fmt::format("entity {}, line {}", number, entity.line)});
    } else if (entity.brushes.empty()) {
      add_point_entity(number);
    } else {
      add_brush_entity(number);
    }
  }

  void add_point_entity(std::size_t number) {
    const formats::Entity& fields = map_.entities[number].fields;
    const auto origin = fields.find_vec3("origin");
    if (origin && region_ && !region_->keeps(math::Vec3d(*origin))) {
      ++entities_left_out_;
      return;
    }
    out_.entities.push_back(level_fields(fields, {}));
    if (!origin) return;
    out_.occupants_world.push_back(math::Vec3d(*origin));
    out_.entity_of_occupant.push_back(number);
  }

  void add_brush_entity(std::size_t number) {
    const formats::MapEntity& entity = map_.entities[number];
    std::vector<Brush> brushes;
    const std::optional<math::Vec3d> pivot = origin_of_brushes(entity);
    const std::size_t left_out_before = brushes_left_out_;
    add_brushes(number, brush_class_of(entity.fields), pivot.value_or(math::Vec3d(0.0)), brushes);
    if (brushes.empty()) {
      add_fields(entity.fields, {});
      if (brushes_left_out_ > left_out_before)
        ++entities_left_out_;
      else
        warnings_.push_back({"brush entity without brushes",
                             fmt::format("entity {} ({}), line {}", number,
                                         base::quotable(entity.fields.classname()), entity.line)});
      return;
    }
    out_.models.push_back(std::move(brushes));
    add_fields(entity.fields, {true, fmt::format("*{}", out_.models.size() - 1),
                               pivot ? fmt::format("{} {} {}", pivot->x, pivot->y, pivot->z) : ""});
  }

  void close_region() {
    constexpr std::uint32_t kNoKeys = 0;
    const math::Vec3d origin_world(0.0);
    BrushClass world;
    world.is_world = true;
    for (const formats::MapBrush& wall : region_->shell())
      if (auto solid = make_solid(wall, region_->place, origin_world, out_.planes, warnings_))
        out_.models.front().push_back(
            to_brush(wall, std::move(*solid), region_->place, world, origin_world, kNoKeys));
    warnings_.push_back({"only a region is compiled",
                         fmt::format("{}; left out: {} brushes, {} entities", describe(region_->place),
                                     brushes_left_out_, entities_left_out_)});
  }

  void warn_without_start() {
    const auto is_start = [](const formats::Entity& fields) {
      return fields.classname() == "info_player_start";
    };
    if (std::ranges::any_of(out_.entities, is_start)) return;
    warnings_.push_back({"no info_player_start", region_ ? "none is in the region: nobody can enter the level"
                                                         : "nobody can enter the level"});
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

  void add_brushes(std::size_t entity_number, const BrushClass& of_class, const math::Vec3d& origin_world,
                   std::vector<Brush>& io_brushes) {
    const formats::MapEntity& entity = map_.entities[entity_number];
    const std::uint32_t keys = add_keys(entity.fields);
    for (std::size_t i = 0; i < entity.brushes.size(); ++i) {
      const formats::MapBrush& from = entity.brushes[i];
      if (special_of(from) == Special::kOrigin || is_region_brush(from)) continue;
      if (auto brush = make_brush(from, {entity_number, i, from.line}, of_class, origin_world, keys))
        io_brushes.push_back(std::move(*brush));
    }
  }

  // Nothing for one without a volume, and for one outside of the region, of which it counts.
  std::optional<Brush> make_brush(const formats::MapBrush& from, const BrushPlace& place,
                                  const BrushClass& of_class, const math::Vec3d& origin_world,
                                  std::uint32_t keys) {
    std::optional<BrushSolid> solid = make_solid(from, place, origin_world, out_.planes, warnings_);
    if (!solid) return std::nullopt;
    if (!region_) return to_brush(from, std::move(*solid), place, of_class, origin_world, keys);
    const Box box_world{solid->box.mins + origin_world, solid->box.maxs + origin_world};
    if (!region_->keeps(box_world)) {
      ++brushes_left_out_;
      return std::nullopt;
    }
    const formats::MapBrush rest = region_->cut(from, box_world);
    Warnings told_already;
    solid = make_solid(rest, place, origin_world, out_.planes, told_already);
    if (!solid) return std::nullopt;
    return to_brush(rest, std::move(*solid), place, of_class, origin_world, keys);
  }

  Brush to_brush(const formats::MapBrush& from, BrushSolid solid, const BrushPlace& place,
                 const BrushClass& of_class, const math::Vec3d& origin_world, std::uint32_t keys) {
    const Special special = special_of(from);
    Brush brush;
    brush.fill = fill_of(special, of_class);
    brush.is_detail = of_class.is_detail;
    brush.keeps_inner_faces = of_class.keeps_inner_faces;
    brush.hulls = hulls_of(special, brush.fill) & of_class.hulls;
    brush.chop_order = of_class.chop_order;
    brush.box = solid.box;
    for (std::size_t k = 0; k < solid.sides.size(); ++k) {
      BrushSide& side = solid.sides[k];
      const formats::MapSide& map_side = from.sides[solid.side_of[k]];
      if (is_drawn(map_side.texture)) side.surface = add_surface(map_side, place, side, origin_world, keys);
      side.is_seen_from_inside = is_liquid(brush.fill) || of_class.is_seen_from_inside;
      side.splits = special != Special::kHint || special_of(map_side.texture) == Special::kHint;
    }
    brush.sides = std::move(solid.sides);
    return brush;
  }

  std::uint32_t add_keys(const formats::Entity& fields) {
    SurfaceKeys keys = surface_keys_of(fields);
    const float of_world = number_or(map_.entities.front().fields, "litwater", 0);
    keys.lights_liquids = number_or(fields, "litwater", of_world) > 0;
    const auto known = std::find(out_.surface_keys.begin(), out_.surface_keys.end(), keys);
    if (known != out_.surface_keys.end())
      return static_cast<std::uint32_t>(known - out_.surface_keys.begin());
    out_.surface_keys.push_back(keys);
    return static_cast<std::uint32_t>(out_.surface_keys.size() - 1);
  }

  std::uint32_t add_surface(const formats::MapSide& from, const BrushPlace& place, const BrushSide& side,
                            const math::Vec3d& origin_world, std::uint32_t keys) {
    const auto warn = [&](const char* kind) {
      warnings_.push_back({kind, describe(place) + fmt::format(", side in line {}", from.line)});
    };
    Surface surface;
    const SideAxes found =
        side_axes(from.texturing, out_.planes[side.plane].normal, texture_size_(from.texture));
    if (found.replaced) warn("texture axes that do not lie on the side");
    TextureAxes axes = found.axes;
    const Special special = special_of(from.texture);
    const bool is_lit =
        special == Special::kNone || (is_liquid(special) && out_.surface_keys[keys].lights_liquids);
    if (is_lit) {
      const bool stretched_s = stretch_to_fit(side.winding, axes.s_axis, axes.s_offset);
      const bool stretched_t = stretch_to_fit(side.winding, axes.t_axis, axes.t_offset);
      if (stretched_s || stretched_t) warn("texture so small, or side so large, that it was stretched");
    }
    // The brush was moved, and its texture with it.
    axes.s_offset += glm::dot(origin_world, axes.s_axis);
    axes.t_offset += glm::dot(origin_world, axes.t_axis);
    surface.texinfo = to_texinfo(axes, add_texture(from.texture), is_lit ? 0 : kUnlitTexinfo);
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

  void add_fields(const formats::Entity& fields, BrushEntity brushes) {
    if (brushes.is_in_level) out_.entities.push_back(level_fields(fields, brushes));
    out_.brush_entities.push_back(std::move(brushes));
  }

  const formats::Map& map_;
  TextureSize texture_size_;

  Warnings& warnings_;
  std::optional<Region> region_;
  std::size_t brushes_left_out_ = 0, entities_left_out_ = 0;  // outside of the region
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
