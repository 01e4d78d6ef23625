// Translucent alias models, one at a time: for the stage that draws everything translucent back to front.
#pragma once

#include <cstddef>
#include <optional>

#include "base/arena.h"
#include "render/alias/place_alias.h"
#include "render/color/color_tables.h"
#include "render/renderer.h"

namespace temblor::render {

// One instance by itself, whatever its alpha, as an opaque picture of its nearest parts, to be blended whole:
// parts that lie behind one another do not shine through, as they would if each triangle were blended by
// itself, in whatever order the mesh has them.
struct AliasPicture {
  // The rectangle of the frame that it may touch.
  int x, y, width, height;
  // Its first pixel, bytes or 0xffRRGGBB, and depth; rows are `stride` apart. Depth is minus infinity where
  // the instance does not show.
  void* pixels;
  float* depth;
  std::size_t stride;
};

// Nothing when it is out of view. What is pointed to is the arena's.
std::optional<AliasPicture> draw_alias_alone(const Scene& scene, const Settings& settings,
                                             const ViewFrame& view, const AliasInstance& instance,
                                             AliasRole role, const ColorTables& tables, PixelFormat format,
                                             base::Arena& arena);

}  // namespace temblor::render
