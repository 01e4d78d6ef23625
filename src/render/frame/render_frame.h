// One frame, from the scene to the finished picture: calls the stages in order.
//
//   Scene -> view -> visible faces -> edges -> spans -> surface draws -> span sources -> picture
//                                                                        + models, sprites, particles
//
// Each stage is a function of the results of earlier stages. Stages share the FrameContext and change nothing
// but the caches that are passed to them, so results never depend on earlier frames.
#pragma once

#include "render/alias/draw_alias_models.h"
#include "render/frame/frame_caches.h"
#include "render/frame_stats.h"
#include "render/surfaces/surface_draws.h"

namespace temblor::render {

// The results of a frame's stages, for statistics and debug views. They live in the arenas until the next
// frame.
struct FrameRecord {
  ViewFrame view;
  VisibleFaces visible;
  EdgeTable edges;
  SpanTable spans;
  SurfaceBlocks surfaces;
  // False: models, sprites, and particles were skipped (Settings::fill_depth).
  bool has_models = false;
  std::span<const PreparedAlias> alias_models{};
  StageTimes times;
};

// `io_caches` must have been prepared for the scene. Writes every pixel of `io_frame`.
FrameRecord render_frame(const FrameContext& context, FrameCaches& io_caches, FrameBuffer& io_frame);

// Counts from the record; `times` are copied. Separate from drawing, so that no stage has to count.
FrameStats collect_frame_stats(const FrameRecord& record, const Scene& scene);

}  // namespace temblor::render
