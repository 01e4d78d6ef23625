// Draws translucent alias models one at a time, for the stage that draws all translucent things back to
// front.
#pragma once

#include <cstddef>
#include <optional>

#include "render/alias/place_alias.h"
#include "render/view/frame_context.h"

namespace temblor::render {

// One instance alone, drawn as if opaque, to be blended into the frame as a whole. So hidden parts of the
// model do not show through its front, as they would if triangles were blended one by one.
struct AliasPicture {
  // The rectangle of the frame that it may touch.
  int x, y, width, height;
  // The first pixel of the rectangle (bytes or 0xffRRGGBB) and its depth; rows are `stride` pixels apart.
  // Depth is minus infinity where the instance does not show.
  void* pixels;
  float* depth;
  std::size_t stride;
};

// Nothing if the instance is out of view. Its alpha is ignored. Pixels live in the frame's arena.
std::optional<AliasPicture> draw_alias_picture(const FrameContext& context, const ViewFrame& view,
                                               const AliasInstance& instance, AliasRole role);

}  // namespace temblor::render
