// `--show`: how the frame was made, drawn over the picture.
#pragma once

#include <span>

#include "render/frame.h"
#include "render/renderer.h"
#include "render/surfaces/surface_draws.h"

namespace temblor::render {

// What the views of `--show` are made from: the last frame's tables.
struct ShownFrame {
  const world::Level& level;
  const ViewFrame& view;
  const EdgeTable& edges;
  const SpanTable& spans;
  const SurfaceDraws& items;
};

void draw_shown(Show show, const ShownFrame& frame, const formats::Palette& palette, FrameBuffer& io_frame);

}  // namespace temblor::render
