// Spans that are drawn from a texture itself, not from a lit surface: faces without light, liquids.
// One texel at a time; only their coordinates come from a kernel.
#pragma once

#include "base/arena.h"
#include "render/frame.h"
#include "render/surfaces/draw_items.h"

namespace temblor::render {

// What all spans of a frame share.
struct TextureRunFrame {
  const ViewFrame& view;
  const BuildTables& tables;
  double time_s;
  bool vector_kernels, fill_depth;
  std::array<float, 128> turbulence;  // texels, by coordinate of the other axis
};
TextureRunFrame make_texture_run_frame(const Scene& scene, const Settings& settings, const ViewFrame& view,
                                       const BuildTables& tables);

void draw_texture_runs(const TextureRunFrame& frame, const DrawItem& item, std::span<const SpanRun> runs,
                       base::Arena& scratch, FrameBuffer& io_frame);

}  // namespace temblor::render
