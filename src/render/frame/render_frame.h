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
#include "render/frame/frame_stages.h"
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

// `io_caches` and its `view` must have been prepared for the scene. Writes every pixel of `io_frame`.
FrameRecord render_frame(const FrameContext& context, const FrameStages& stages, FrameCaches& io_caches,
                         FrameBuffer& io_frame);

// render_frame in parts: the stages before the surface cache, which only one thread may change, and those
// after it. Different views may run each part at the same time (render_views.h).
//
// `frame`: only its size counts.
SurfaceRequests find_surfaces(const FrameContext& context, const FrameStages& stages, const LevelData& level,
                              const FrameBuffer& frame, FrameRecord& io_record);
// Needs the record with its surfaces. While others use `io_skybox`, it must be that of the scene already.
void draw_surfaces(const FrameContext& context, const FrameStages& stages, PreparedSkybox& io_skybox,
                   ViewCaches& io_view, FrameRecord& io_record, FrameBuffer& io_frame);

// Draws the debug view of the settings, and the scene's lines, over the finished picture.
void draw_over_picture(const FrameContext& context, const FrameRecord& record, FrameBuffer& io_frame);

// Counts from the record; `times` are copied. Separate from drawing, so that no stage has to count.
FrameStats collect_frame_stats(const FrameRecord& record, const Scene& scene);

}  // namespace temblor::render
