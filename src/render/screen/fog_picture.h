// Fog over the opaque picture: every pixel by its depth, sky by a constant share.
#pragma once

#include "base/parallel_for.h"
#include "render/colour/fog.h"
#include "render/edges/span_table.h"
#include "render/frame.h"
#include "render/surfaces/draw_items.h"

namespace temblor::render {

// Sky is told by the depth that drawing its spans left: what was drawn over it since is nearer. Without
// density nothing is touched.
void fog_picture(const FrameFog& fog, const SpanTable& spans, const DrawItems& items, base::Jobs& jobs,
                 FrameBuffer& io_frame);

}  // namespace temblor::render
