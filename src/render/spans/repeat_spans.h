// Spans that are drawn from a texture itself, not from a lit surface: liquids, and faces without light.
#pragma once

#include "base/arena.h"
#include "render/frame.h"
#include "render/spans/span_kernels.h"
#include "render/surfaces/surface_draws.h"

namespace temblor::render {

// For every liquid and texture item, all that its spans need but the spans; by item number, null for others.
// Memory comes from `arena`.
std::span<const RepeatRuns*> prepare_repeat_runs(const Scene& scene, const ViewFrame& view,
                                                 const SurfaceDraws& items, const ColorTables& tables,
                                                 PixelFormat format, base::Arena& arena);

}  // namespace temblor::render
