// A part of a map that is compiled alone, so that a mapper sees soon what they work at. A brush all of whose
// textures end in "region" bounds it; brushes whose textures end in "antiregion" leave out what they touch.
#pragma once

#include <optional>
#include <vector>

#include "base/result.h"
#include "compiler/bsp/brushes/brush.h"
#include "formats/levels/map.h"

namespace temblor::compiler {

// Whether a brush is one of those two, which are themselves no part of the level.
bool is_region_brush(const formats::MapBrush& brush);

struct Region {
  Box bounds_world;              // of the region brush; without one, of all brushes
  std::vector<Box> left_out;     // by antiregion brushes
  formats::MapBrush from_brush;  // the region brush, or the first of the others
  BrushPlace place;

  // Boxes that only touch have nothing in common.
  bool keeps(const Box& box_world) const;
  bool keeps(const math::Vec3d& point_world) const;
  // The brush, of that box, cut where it would stick out of the shell.
  formats::MapBrush cut(const formats::MapBrush& brush, const Box& box_world) const;
  // Six brushes around the bounds, in from_brush's texture, so that the level is closed.
  std::vector<formats::MapBrush> shell() const;
};

// Nothing where no brush asks for it. Errors name entity, brush and line: a second region brush, or one
// without a volume.
base::Result<std::optional<Region>> find_region(const formats::Map& map, Warnings& io_warnings);

}  // namespace temblor::compiler
