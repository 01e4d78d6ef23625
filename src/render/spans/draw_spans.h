// Stage 6. SpanTable and SurfaceDraws -> pixels and depth, band by band.
#pragma once

#include "render/frame.h"
#include "render/spans/span_sources.h"

namespace temblor::render {

// All but late items.
void draw_spans(const Settings& settings, const ViewFrame& view, const Band& band, const SpanSources& sources,
                const ColorTables& tables, FrameBuffer& io_frame);

}  // namespace temblor::render
