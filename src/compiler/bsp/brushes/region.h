// Compiling only a part of a map, so that mappers quickly see what they work on. A brush whose textures all
// end in "region" bounds the part; brushes whose textures all end in "antiregion" leave out what they touch.
// (The names are those of TrenchBroom's and qbsp's region brushes.)
#pragma once

#include <optional>
#include <vector>

#include "base/result.h"
#include "compiler/bsp/brushes/brush.h"
#include "formats/levels/map.h"

namespace temblor::compiler {

// Whether a brush is one of the two. They are not part of the level.
bool is_region_brush(const formats::MapBrush& brush);

// The part of the map that is compiled, in world coordinates.
struct Region {
  Box bounds_world;              // of the region brush; without one, of the whole map
  std::vector<Box> left_out;     // boxes of the antiregion brushes
  formats::MapBrush from_brush;  // the region brush, or the first antiregion brush
  BrushPlace place;

  // Whether something is in the region. Boxes that only touch are not.
  bool keeps(const Box& box_world) const;
  bool keeps(const math::Vec3d& point_world) const;
  // Cuts off the part of a brush (with that box) that would stick out of the shell.
  formats::MapBrush cut(const formats::MapBrush& brush, const Box& box_world) const;
  // Six brushes around the bounds, in from_brush's texture, that seal the level.
  std::vector<formats::MapBrush> shell() const;
};

// Returns nothing if the map has no region brushes. Errors name entity, brush and line: a second region
// brush, or one without volume.
base::Result<std::optional<Region>> find_region(const formats::Map& map, Warnings& io_warnings);

}  // namespace temblor::compiler
