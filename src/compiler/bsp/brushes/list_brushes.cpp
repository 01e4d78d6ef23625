#include "compiler/bsp/brushes/list_brushes.h"

#include <optional>
#include <utility>

#include "world/level.h"

namespace temblor::compiler {
namespace {

constexpr std::size_t kPlayerHull = 1;

// Returns nothing for a brush that is not in the list.
std::optional<std::int16_t> find_listed_contents(const Brush& brush) {
  const auto contents = [](world::Contents of_leaf) { return static_cast<std::int16_t>(of_leaf); };
  switch (brush.fill) {
    case Fill::kEmpty:
    case Fill::kIllusionary:
    case Fill::kVisBlocker:
      return std::nullopt;
    case Fill::kWater:
      return contents(world::Contents::kWater);
    case Fill::kSlime:
      return contents(world::Contents::kSlime);
    case Fill::kLava:
      return contents(world::Contents::kLava);
    case Fill::kSky:
      return contents(world::Contents::kSky);
    case Fill::kFence:
    case Fill::kDetailWall:
    case Fill::kDetail:
    case Fill::kSolid:
      break;
  }
  if ((brush.hulls & hull_bit(kPlayerHull)) == 0) return std::nullopt;
  return (brush.hulls & kDrawnHull) != 0 ? contents(world::Contents::kSolid) : formats::kClipContents;
}

formats::ListedBrush make_listed_brush(const Brush& brush, const PlaneSet& planes, std::int16_t contents) {
  constexpr int kNotAxial = 3;
  formats::ListedBrush listed{math::Vec3(brush.box.mins), math::Vec3(brush.box.maxs), contents, {}};
  for (const BrushSide& side : brush.sides) {
    const Plane& plane = planes[side.plane];
    if (plane.axis == kNotAxial)
      listed.planes.push_back({math::Vec3(plane.normal), static_cast<float>(plane.distance)});
  }
  return listed;
}

}  // namespace

std::vector<formats::ListedModel> list_brushes(const LevelBrushes& level) {
  std::vector<formats::ListedModel> models;
  for (std::size_t model = 0; model < level.models.size(); ++model) {
    formats::ListedModel listed{static_cast<std::uint32_t>(model), {}};
    for (const Brush& brush : level.models[model])
      if (const auto contents = find_listed_contents(brush))
        listed.brushes.push_back(make_listed_brush(brush, level.planes, *contents));
    if (!listed.brushes.empty()) models.push_back(std::move(listed));
  }
  return models;
}

}  // namespace temblor::compiler
