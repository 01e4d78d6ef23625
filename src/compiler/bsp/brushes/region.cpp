#include "compiler/bsp/brushes/region.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "base/text.h"

namespace temblor::compiler {
namespace {

constexpr double kShellUnits = 16;

enum class Part { kNone, kRegion, kAntiregion };

// Whether the names of all textures on the brush have that ending.
bool all_end_in(const formats::MapBrush& brush, std::string_view ending) {
  return std::ranges::all_of(brush.sides, [&](const formats::MapSide& side) {
    return base::to_lower(side.texture).ends_with(ending);
  });
}

Part classify(const formats::MapBrush& brush) {
  if (brush.sides.empty() || !all_end_in(brush, "region")) return Part::kNone;
  return all_end_in(brush, "antiregion") ? Part::kAntiregion : Part::kRegion;
}

bool overlap(const Box& a, const Box& b) {
  return glm::all(glm::lessThan(a.mins + kOnPlaneEpsilon, b.maxs)) &&
         glm::all(glm::lessThan(b.mins + kOnPlaneEpsilon, a.maxs));
}

bool holds(const Box& box, const math::Vec3d& point) {
  return glm::all(glm::lessThan(box.mins, point)) && glm::all(glm::lessThan(point, box.maxs));
}

// A side across an axis, facing up or down along it.
formats::MapSide make_axial_side(int axis, double at, bool faces_up, std::string_view texture,
                                 std::uint32_t line) {
  formats::MapSide side;
  side.texture = texture;
  side.line = line;
  for (math::Vec3d& point : side.points_world) point[axis] = at;
  side.points_world[faces_up ? 0 : 2][(axis + 1) % 3] = 1;
  side.points_world[faces_up ? 2 : 0][(axis + 2) % 3] = 1;
  return side;
}

std::optional<Box> compute_box(const formats::MapBrush& brush, const BrushPlace& place,
                               Warnings& io_warnings) {
  PlaneSet planes;
  const auto solid = make_solid(brush, place, math::Vec3d(0.0), planes, io_warnings);
  return solid ? std::optional(solid->box) : std::nullopt;
}

Box grown(Box box, double units) {
  box.mins -= units;
  box.maxs += units;
  return box;
}

// Collects the region brushes of a map.
class RegionFinder {
 public:
  RegionFinder(const formats::Map& map, Warnings& io_warnings) : map_(map), warnings_(io_warnings) {}

  base::Result<std::optional<Region>> find() {
    for (std::size_t entity = 0; entity < map_.entities.size(); ++entity) {
      const auto& brushes = map_.entities[entity].brushes;
      for (std::size_t i = 0; i < brushes.size(); ++i)
        if (is_region_brush(brushes[i])) TRY_STATUS(take(brushes[i], {entity, i, brushes[i].line}));
    }
    if (!found_) return std::optional<Region>{};
    if (!has_bounds_) found_->bounds_world = find_full_box();
    return std::move(found_);
  }

 private:
  // Adds a region or antiregion brush. A region brush must be unique and have a volume.
  base::Status take(const formats::MapBrush& brush, const BrushPlace& place) {
    const bool is_bounds = classify(brush) == Part::kRegion;
    if (is_bounds && has_bounds_)
      return base::malformed("{}: second region brush: delete it, or the first one ({})", describe(place),
                             describe(found_->place));
    const std::optional<Box> box = compute_box(brush, place, warnings_);
    if (!box) {
      if (is_bounds)
        return base::malformed("{}: the region brush has no volume or is not closed", describe(place));
      return base::Ok{};
    }
    if (!found_ || is_bounds) {
      if (!found_) found_.emplace();
      found_->from_brush = brush;
      found_->place = place;
    }
    if (is_bounds)
      found_->bounds_world = *box;
    else
      found_->left_out.push_back(*box);
    has_bounds_ |= is_bounds;
    return base::Ok{};
  }

  Box find_full_box() const {
    Box all;
    Warnings reported_later;  // when the level is made of them
    for (const formats::MapEntity& entity : map_.entities)
      for (const formats::MapBrush& brush : entity.brushes)
        if (const auto box = compute_box(brush, {}, reported_later)) {
          all.add(box->mins);
          all.add(box->maxs);
        }
    return all;
  }

  const formats::Map& map_;
  Warnings& warnings_;
  std::optional<Region> found_;
  bool has_bounds_ = false;
};

}  // namespace

bool is_region_brush(const formats::MapBrush& brush) {
  return classify(brush) != Part::kNone;
}

bool Region::keeps(const Box& box_world) const {
  return overlap(box_world, bounds_world) &&
         std::ranges::none_of(left_out, [&](const Box& box) { return overlap(box_world, box); });
}

bool Region::keeps(const math::Vec3d& point_world) const {
  return holds(bounds_world, point_world) &&
         std::ranges::none_of(left_out, [&](const Box& box) { return holds(box, point_world); });
}

formats::MapBrush Region::cut(const formats::MapBrush& brush, const Box& box_world) const {
  const Box outer = grown(bounds_world, kShellUnits);
  formats::MapBrush rest = brush;
  // "skip", because the shell hides the place where the brush is cut.
  for (int axis = 0; axis < 3; ++axis) {
    if (box_world.mins[axis] < outer.mins[axis])
      rest.sides.push_back(make_axial_side(axis, outer.mins[axis], false, "skip", brush.line));
    if (box_world.maxs[axis] > outer.maxs[axis])
      rest.sides.push_back(make_axial_side(axis, outer.maxs[axis], true, "skip", brush.line));
  }
  return rest;
}

std::vector<formats::MapBrush> Region::shell() const {
  const Box outer = grown(bounds_world, kShellUnits);
  std::vector<formats::MapBrush> walls;
  for (int across = 0; across < 3; ++across)
    for (const bool is_upper : {false, true}) {
      Box box = outer;
      (is_upper ? box.mins : box.maxs)[across] = (is_upper ? bounds_world.maxs : bounds_world.mins)[across];
      formats::MapBrush wall;
      wall.line = place.line;
      for (int axis = 0; axis < 3; ++axis)
        for (const bool faces_up : {false, true})
          wall.sides.push_back(make_axial_side(axis, (faces_up ? box.maxs : box.mins)[axis], faces_up,
                                               from_brush.sides.front().texture, place.line));
      walls.push_back(std::move(wall));
    }
  return walls;
}

base::Result<std::optional<Region>> find_region(const formats::Map& map, Warnings& io_warnings) {
  return RegionFinder(map, io_warnings).find();
}

}  // namespace temblor::compiler
