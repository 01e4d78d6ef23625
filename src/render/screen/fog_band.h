// Stage 8. Fog over the opaque picture of a band: every pixel by its depth, sky by a constant share.
#pragma once

#include "base/arena.h"
#include "render/color/fog.h"
#include "render/edges/span_table.h"
#include "render/frame_buffer.h"
#include "render/surfaces/surface_draws.h"

namespace temblor::render {

// A pixel of a sky span is still sky if it has the depth that drawing the span wrote; anything drawn over it
// since is nearer. Without fog nothing changes.
void fog_band(const FrameFog& fog, const Band& band, const SurfaceDraws& draws, base::Arena& arena,
              FrameBuffer& io_frame);

}  // namespace temblor::render
