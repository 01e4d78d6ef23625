// Debug views (`--show` and r_show): how a frame was made, drawn over its picture. For example the faces,
// spans, mip levels, or overdraw, each in distinct colors.
#pragma once

#include <span>

#include "render/frame_buffer.h"
#include "render/settings.h"
#include "render/surfaces/surface_draws.h"

namespace temblor::render {

// The tables of the last frame that debug views are made from.
struct DebugViewInput {
  const world::Level& level;
  const ViewFrame& view;
  const EdgeTable& edges;
  const SpanTable& spans;
  const SurfaceDraws& draws;
};

// Does nothing for Show::kPicture. Indexed frames show the nearest palette entries.
void draw_debug_view(Show show, const DebugViewInput& frame, const formats::Palette& palette,
                     FrameBuffer& io_frame);

}  // namespace temblor::render
