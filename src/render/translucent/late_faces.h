// Stage 9. Late faces (view/face_opacity.h) -> pixels, one face at a time, tested against depth: first
// those that are opaque but for their holes, before models; then, when all that is opaque is there, the
// translucent ones from back to front.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/arena.h"
#include "base/parallel_for.h"
#include "render/colour/fog.h"
#include "render/frame.h"
#include "render/spans/span_sources.h"

namespace temblor::render {

struct LateFace {
  SurfaceIndex surface;
  FaceOpacity opacity;
  SortKey key;
  double depth;  // ViewFrame::depth, in the middle of what it covers
};

// Only what has spans.
struct LateFaces {
  std::span<const LateFace> opaque;
  std::span<const LateFace> translucent;  // back to front
};

// Back to front is by key; brush models in one leaf, which share it, go by where they are seen.
LateFaces sort_late_faces(const Scene& scene, const VisibleFaces& visible, const EdgeTable& edges,
                          const SpanTable& spans, const DrawItems& items, base::Arena& arena);

struct LateTarget {
  const SpanTable& spans;
  const EdgeTable& edges;
  const SpanSources& sources;
  const ColourTables& tables;
  const FrameFog& fog;
  const ViewFrame& view;
};

// Draws what lies in one band of all of them, in their order. Opaque ones write pixels and depth, and are
// fogged with the rest of the picture; translucent ones are fogged, then blended, and leave depth alone.
void draw_late_faces(std::span<const LateFace> faces, const LateTarget& target, const Band& band,
                     base::Arena& arena, FrameBuffer& io_frame);

// The same in all bands. `io_arenas` grows as needed: one a band.
void draw_late_faces(std::span<const LateFace> faces, const LateTarget& target, base::Jobs& jobs,
                     std::vector<base::Arena>& io_arenas, FrameBuffer& io_frame);

}  // namespace temblor::render
