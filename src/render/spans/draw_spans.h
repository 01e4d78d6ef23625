// Stage 6. SpanTable and DrawItems -> pixels and depth. Bands are drawn independently of one another.
#pragma once

#include "base/arena.h"
#include "base/parallel_for.h"
#include "render/frame.h"
#include "render/surfaces/draw_items.h"

namespace temblor::render {

void draw_spans(const Scene& scene, const Settings& settings, const ViewFrame& view, const SpanTable& spans,
                const DrawItems& items, const ColourTables& tables, base::Jobs& jobs, base::Arena& arena,
                FrameBuffer& io_frame);

}  // namespace temblor::render
