// Stage 9. Deferred faces (view/face_opacity.h) -> pixels, one face at a time, tested against depth. Faces
// that are opaque except for their holes come first, before models. Translucent faces come when everything
// opaque is drawn, from back to front. Stock Quake has neither.
#pragma once

#include <cstdint>
#include <span>

#include "base/arena.h"
#include "render/color/fog.h"
#include "render/frame_buffer.h"
#include "render/spans/span_sources.h"

namespace temblor::render {

// A deferred face on the screen.
struct DeferredFace {
  SurfaceIndex surface;
  FaceOpacity opacity;
  SortKey key;
  double depth;  // ViewFrame::depth at the center of the pixels that it covers
  std::uint64_t pixels;
};

// Only faces that have spans.
struct DeferredFaces {
  std::span<const DeferredFace> opaque;
  std::span<const DeferredFace> translucent;  // back to front
};

// Everything that the world's pixels are made from: references to the results of earlier stages.
struct WorldPicture {
  const SpanTable& spans;
  const EdgeTable& edges;
  const SpanSources& sources;
  const ColorTables& colors;
  const FrameFog& fog;
  const ViewFrame& view;
};

// Sorts by key. Brush models in one leaf share a key, so they are sorted by depth.
DeferredFaces sort_deferred_faces(const FrameContext& context, const WorldPicture& world,
                                  const VisibleFaces& visible);

// Draws the part of the faces in one band, in their order. Opaque faces write pixels and depth, and are
// fogged later with the whole picture. Translucent faces are fogged, then blended, and do not write depth.
// Additive faces are not fogged: they would add the fog's color.
void draw_deferred_faces(std::span<const DeferredFace> faces, const WorldPicture& world, const Band& band,
                         base::Arena& arena, FrameBuffer& io_frame);

}  // namespace temblor::render
