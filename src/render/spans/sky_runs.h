// Spans of sky: two layers that scroll over one another (the texture's left half, clouds, and behind its
// clear texels its right half), seen along the ray of each pixel.
#pragma once

#include "base/arena.h"
#include "render/frame.h"
#include "render/spans/span_kernels.h"
#include "render/surfaces/draw_items.h"

namespace temblor::render {

// One sky texture made ready for a frame: its layers in the frame's pixel format, scrolled.
struct SkyLayers {
  SkyRuns runs;  // lacks the spans and their depth
};

// For every sky item; by item number, null for others. Memory comes from `arena`.
std::span<const SkyLayers*> prepare_sky_layers(const Scene& scene, const ViewFrame& view,
                                               const DrawItems& items, const BuildTables& tables,
                                               PixelFormat format, base::Arena& arena);

}  // namespace temblor::render
