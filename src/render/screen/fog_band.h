// Stage 8. Fog over what is opaque in a band: every pixel by its depth, sky by a constant share.
#pragma once

#include "base/arena.h"
#include "render/color/fog.h"
#include "render/edges/span_table.h"
#include "render/frame.h"
#include "render/surfaces/surface_draws.h"

namespace temblor::render {

// Sky is told by the depth that drawing its spans left: what was drawn over it since is nearer. Without
// density nothing is touched.
void fog_band(const FrameFog& fog, const Band& band, const SurfaceDraws& items, base::Arena& arena,
              FrameBuffer& io_frame);

}  // namespace temblor::render
