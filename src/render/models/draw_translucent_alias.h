// Translucent alias models, one at a time: for the stage that draws everything translucent back to front.
#pragma once

#include <cstdint>
#include <optional>

#include "base/arena.h"
#include "render/colour/colour_tables.h"
#include "render/models/place_alias.h"
#include "render/renderer.h"

namespace temblor::render {

// One instance by itself, whatever its alpha, as an opaque picture of its nearest parts.
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
                                             AliasRole role, const ColourTables& tables, PixelFormat format,
                                             base::Arena& arena);

struct AliasBlend {
  // kIndexed: table[over * 256 + under] is what shows of index `over` before index `under`. Null: opaque.
  const std::uint8_t* table = nullptr;
  int opacity_256 = 256;  // kRgb: of 256
};

// Blends the instance's nearest parts, each pixel once, into the frame where they are nearer than its depth
// or as near; depth stays as it is.
void draw_alias_instance(const Scene& scene, const Settings& settings, const ViewFrame& view,
                         const AliasInstance& instance, AliasRole role, const AliasBlend& blend,
                         const ColourTables& tables, base::Arena& arena, FrameBuffer& io_frame);

}  // namespace temblor::render
