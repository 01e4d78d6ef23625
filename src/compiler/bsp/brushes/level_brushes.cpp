// Method: one pass over the map's entities. Brushes of worldspawn, groups and details go to model 0, and
// every other entity with brushes becomes a model of its own. Planes, surfaces, keys and textures are
// numbered in the order in which they first appear, so the numbers are the same in every run.
#include "compiler/bsp/brushes/level_brushes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <string_view>
#include <tuple>

#include "base/text.h"
#include "compiler/bsp/brushes/brush_class.h"
#include "compiler/bsp/brushes/entity_faults.h"
#include "compiler/bsp/brushes/key_values.h"
#include "compiler/bsp/brushes/level_entities.h"
#include "compiler/bsp/brushes/region.h"
#include "compiler/light/sources/keys.h"
#include "compiler/light/surface_keys.h"
#include "compiler/textures/texture_axes.h"

namespace temblor::compiler {
namespace {

// Lit faces are cut every 240 texels, so a side with a very small texture would become a huge number of
// faces. Stretches the texture so that at most 128 x 128 remain; returns whether it did.
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

// Holds the result while the entities are read, one after another.
class BrushSorter {
 public:
  BrushSorter(const formats::Map& map, TextureSize texture_size, Warnings& io_warnings)
      : map_(map), texture_size_(texture_size), warnings_(io_warnings) {
    out_.models.emplace_back();
    out_.surface_keys.emplace_back();
  }

  base::Result<LevelBrushes> sort() {
    TRY_STATUS(check_worldspawn(map_));
    TRY(region_, find_region(map_, warnings_));
    for (std::size_t i = 0; i < map_.entities.size(); ++i) add_entity(i);
    out_.is_region = region_.has_value();
    if (region_) close_region();
    // Stable: brushes with equal _chop_order keep the order of the map, in which the last one wins.
    for (std::vector<Brush>& brushes : out_.models) std::ranges::stable_sort(brushes, {}, &Brush::chop_order);
    if (out_.models.front().empty())
      return base::malformed("the world has no brush with a volume: add a room to worldspawn");
    warn_if_no_start();
    warn_about_unreadable_values(map_, warnings_);
    warn_about_entity_faults(map_, warnings_);
    return std::move(out_);
  }

 private:
  void add_entity(std::size_t number) {
    const formats::MapEntity& entity = map_.entities[number];
    if (const BrushClass of_class = find_brush_class(entity.fields); of_class.is_world) {
      add_brushes(number, of_class, math::Vec3d(0.0), out_.models.front());
      add_fields(entity.fields, {number == 0, {}, {}});
      if (number > 0 && entity.fields.classname() == "worldspawn")
        warnings_.push_back({"more than one worldspawn",
                             fmt::format("entity {}, line {}: only its brushes are used, not its keys",
                                         number, entity.line)});
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
    out_.entities.push_back(make_level_fields(fields, {}));
    if (!origin) return;
    out_.occupants_world.push_back(math::Vec3d(*origin));
    out_.entity_of_occupant.push_back(number);
  }

  // Brushes are stored relative to the pivot, which becomes the entity's origin, so the game turns them about
  // it.
  void add_brush_entity(std::size_t number) {
    const formats::MapEntity& entity = map_.entities[number];
    std::vector<Brush> brushes;
    const std::optional<math::Vec3d> pivot = find_origin_brush(entity);
    const std::size_t left_out_before = brushes_left_out_;
    add_brushes(number, find_brush_class(entity.fields), pivot.value_or(math::Vec3d(0.0)), brushes);
    if (brushes.empty()) {
      add_fields(entity.fields, {});
      if (brushes_left_out_ > left_out_before)
        ++entities_left_out_;
      else
        warnings_.push_back({"brush entity without brushes",
                             fmt::format("entity {} ({}), line {}: left out of the level", number,
                                         base::quotable(entity.fields.classname()), entity.line)});
      return;
    }
    out_.models.push_back(std::move(brushes));
    add_fields(entity.fields, {true, fmt::format("*{}", out_.models.size() - 1),
                               pivot ? fmt::format("{} {} {}", pivot->x, pivot->y, pivot->z) : ""});
  }

  // Surrounds the region by walls and reports what was left out.
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
                         fmt::format("{}; left out: {} {}, {} {}", describe(region_->place),
                                     brushes_left_out_, brushes_left_out_ == 1 ? "brush" : "brushes",
                                     entities_left_out_, entities_left_out_ == 1 ? "entity" : "entities")});
  }

  void warn_if_no_start() {
    const auto is_start = [](const formats::Entity& fields) {
      return fields.classname() == "info_player_start";
    };
    if (std::ranges::any_of(out_.entities, is_start)) return;
    warnings_.push_back(
        {"no info_player_start", region_ ? "the region has none, so players cannot enter the level"
                                         : "players cannot enter the level: add one where they begin"});
  }

  // The point about which an entity turns: the center of its brush textured "origin".
  std::optional<math::Vec3d> find_origin_brush(const formats::MapEntity& entity) {
    for (const formats::MapBrush& brush : entity.brushes) {
      if (find_special_texture(brush) != SpecialTexture::kOrigin) continue;
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
      if (find_special_texture(from) == SpecialTexture::kOrigin || is_region_brush(from)) continue;
      if (auto brush = make_brush(from, {entity_number, i, from.line}, of_class, origin_world, keys))
        io_brushes.push_back(std::move(*brush));
    }
  }

  // Returns nothing for a brush without volume or outside the region; counts the latter.
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
    Warnings reported_before;
    solid = make_solid(rest, place, origin_world, out_.planes, reported_before);
    if (!solid) return std::nullopt;
    return to_brush(rest, std::move(*solid), place, of_class, origin_world, keys);
  }

  // Gives a solid its fill, hulls and surfaces, by its textures and its entity's class.
  Brush to_brush(const formats::MapBrush& from, BrushSolid solid, const BrushPlace& place,
                 const BrushClass& of_class, const math::Vec3d& origin_world, std::uint32_t keys) {
    const SpecialTexture special = find_special_texture(from);
    Brush brush;
    brush.fill = find_fill(special, of_class);
    brush.is_detail = of_class.is_detail;
    brush.keeps_inner_faces = of_class.keeps_inner_faces;
    brush.hulls = find_hulls(special, brush.fill) & of_class.hulls;
    brush.chop_order = of_class.chop_order;
    brush.box = solid.box;
    for (std::size_t k = 0; k < solid.sides.size(); ++k) {
      BrushSide& side = solid.sides[k];
      const formats::MapSide& map_side = from.sides[solid.side_of[k]];
      if (is_drawn(map_side.texture)) side.surface = add_surface(map_side, place, side, origin_world, keys);
      side.is_seen_from_inside = is_liquid(brush.fill) || of_class.is_seen_from_inside;
      side.splits =
          special != SpecialTexture::kHint || find_special_texture(map_side.texture) == SpecialTexture::kHint;
    }
    brush.sides = std::move(solid.sides);
    return brush;
  }

  // Returns the index of an entity's surface keys; equal ones are stored once.
  std::uint32_t add_keys(const formats::Entity& fields) {
    SurfaceKeys keys = read_surface_keys(fields);
    if (!read_lights_liquids(fields))
      keys.lights_liquids = read_lights_liquids(map_.entities.front().fields).value_or(true);
    const auto known = std::find(out_.surface_keys.begin(), out_.surface_keys.end(), keys);
    if (known != out_.surface_keys.end())
      return static_cast<std::uint32_t>(known - out_.surface_keys.begin());
    out_.surface_keys.push_back(keys);
    return static_cast<std::uint32_t>(out_.surface_keys.size() - 1);
  }

  // Returns the index of what a side shows; equal surfaces are stored once, so that their faces can be
  // merged.
  std::uint32_t add_surface(const formats::MapSide& from, const BrushPlace& place, const BrushSide& side,
                            const math::Vec3d& origin_world, std::uint32_t keys) {
    const auto warn = [&](const char* kind) {
      warnings_.push_back({kind, describe(place) + fmt::format(", side on line {}", from.line)});
    };
    Surface surface;
    const SideAxes found =
        make_side_axes(from.texturing, out_.planes[side.plane].normal, texture_size_(from.texture));
    if (found.replaced) warn("unusable texture axes, replaced by the default alignment");
    TextureAxes axes = found.axes;
    const SpecialTexture special = find_special_texture(from.texture);
    const bool is_lit =
        special == SpecialTexture::kNone || (is_liquid(special) && out_.surface_keys[keys].lights_liquids);
    if (is_lit) {
      const bool stretched_s = stretch_to_fit(side.winding, axes.s_axis, axes.s_offset);
      const bool stretched_t = stretch_to_fit(side.winding, axes.t_axis, axes.t_offset);
      if (stretched_s || stretched_t) warn("texture too small for its side, stretched");
    }
    // The brush was moved, so its texture moves with it.
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

  // Records what became of an entity with brushes, and adds it to the level if it is in it.
  void add_fields(const formats::Entity& fields, BrushEntity brushes) {
    if (brushes.is_in_level) out_.entities.push_back(make_level_fields(fields, brushes));
    out_.brush_entities.push_back(std::move(brushes));
  }

  const formats::Map& map_;
  TextureSize texture_size_;

  Warnings& warnings_;
  std::optional<Region> region_;
  std::size_t brushes_left_out_ = 0, entities_left_out_ = 0;  // outside the region
  LevelBrushes out_;
  std::map<std::string, std::int32_t> textures_;
  std::map<std::tuple<std::array<float, 8>, std::int32_t, std::uint32_t>, std::uint32_t> surfaces_;
};

}  // namespace

base::Result<LevelBrushes> sort_brushes(const formats::Map& map, TextureSize texture_size,
                                        Warnings& io_warnings) {
  return BrushSorter(map, texture_size, io_warnings).sort();
}

}  // namespace temblor::compiler
