// Stage 9. Late faces (view/face_opacity.h) -> pixels, one face at a time, tested against depth: first
// those that are opaque but for their holes, before models; then, when all that is opaque is there, the
// translucent ones from back to front.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/arena.h"
#include "base/parallel_for.h"
#include "render/color/fog.h"
#include "render/frame.h"
#include "render/spans/span_sources.h"

namespace temblor::render {

struct DeferredFace {
  SurfaceIndex surface;
  FaceOpacity opacity;
  SortKey key;
  double depth;  // ViewFrame::depth, in the middle of what it covers
};

// Only what has spans.
struct DeferredFaces {
  std::span<const DeferredFace> opaque;
  std::span<const DeferredFace> translucent;  // back to front
};

// Back to front is by key; brush models in one leaf, which share it, go by where they are seen.
DeferredFaces sort_deferred_faces(const Scene& scene, const VisibleFaces& visible, const EdgeTable& edges,
                                  const SpanTable& spans, const SurfaceDraws& items, base::Arena& arena);

struct LateTarget {
  const SpanTable& spans;
  const EdgeTable& edges;
  const SpanSources& sources;
  const ColorTables& tables;
  const FrameFog& fog;
  const ViewFrame& view;
};

// Draws what lies in one band of all of them, in their order. Opaque ones write pixels and depth, and are
// fogged with the rest of the picture; translucent ones are fogged, then blended, and leave depth alone.
void draw_deferred_faces(std::span<const DeferredFace> faces, const LateTarget& target, const Band& band,
                         base::Arena& arena, FrameBuffer& io_frame);

// The same in all bands. `io_arenas` grows as needed: one a band.
void draw_deferred_faces(std::span<const DeferredFace> faces, const LateTarget& target, base::Jobs& jobs,
                         std::vector<base::Arena>& io_arenas, FrameBuffer& io_frame);

}  // namespace temblor::render
