// Stage 6. SpanTable and SurfaceDraws -> pixels and depth, one band at a time.
//
// Spans of one draw are drawn together, so that the texels of its block are in the processor's caches
// (Abrash, "Sorted Spans in Action"). Depth is written for every pixel without a test, since spans do not
// overlap; Abrash calls this z-filling ("Consider the Alternatives: Quake's Hidden-Surface Removal").
#pragma once

#include "render/frame_buffer.h"
#include "render/spans/span_sources.h"

namespace temblor::render {

// Draws all spans of the band except those of deferred faces.
void draw_band_spans(const FrameContext& context, const ViewFrame& view, const Band& band,
                     const SpanSources& sources, FrameBuffer& io_frame);

}  // namespace temblor::render
