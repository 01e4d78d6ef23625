// Stage 6. SpanTable and DrawItems -> pixels and depth. Bands are drawn independently of one another.
#pragma once

#include "base/parallel_for.h"
#include "render/frame.h"
#include "render/spans/span_sources.h"

namespace temblor::render {

// All but late items.
void draw_spans(const Settings& settings, const ViewFrame& view, const SpanTable& spans,
                const SpanSources& sources, const ColourTables& tables, base::Jobs& jobs,
                FrameBuffer& io_frame);

}  // namespace temblor::render
