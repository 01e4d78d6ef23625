#include "app/demo/demo_run.h"

#include <utility>

namespace temblor::app {

DemoRun::DemoRun(DemoPlayback playback, SceneDrawer drawer, const FrameOptions& frame,
                 const render::Settings& settings)
    : playback_(std::move(playback)),
      render_settings_(settings),
      drawer_(std::move(drawer)),
      frame_(frame.size.width, frame.size.height, frame.format) {
  playback_.settings().view.fov_deg = frame.fov_deg;
}

// Presents the first moment, so that there is a scene to draw.
base::Result<DemoRun> DemoRun::start(const LoadedDemo& demo, const FrameOptions& frame,
                                     const client::PresentationSettings& presentation,
                                     const render::Settings& settings) {
  TRY(DemoPlayback playback, DemoPlayback::open(demo, presentation));
  TRY(SceneDrawer drawer, SceneDrawer::make(frame.renderer, demo.look.palette, demo.look.colormap));
  DemoRun run(std::move(playback), std::move(drawer), frame, settings);
  TRY_STATUS(run.advance_by_packet());
  return run;
}

// The overlay depends on the size of the frame, so it is laid out here and not by the playback.
void DemoRun::lay_out_overlay() {
  overlay_ = &playback_.presentation().draw_list(playback_.state(), frame_.width(), frame_.height(),
                                                 playback_.settings());
}

base::Result<bool> DemoRun::advance_to(double time_s) {
  TRY(const bool has_more, playback_.advance_to(time_s));
  lay_out_overlay();
  return has_more;
}

base::Result<bool> DemoRun::advance_by_packet() {
  TRY(const bool has_more, playback_.advance_by_packet());
  lay_out_overlay();
  return has_more;
}

base::Status DemoRun::warm_up() {
  if (frame_.format() == render::PixelFormat::kIndexed) drawer_.make_blend_tables();
  TRY_STATUS(draw());
  return base::Ok{};
}

base::Result<render::FrameStats> DemoRun::draw() {
  TRY(render::FrameStats stats, drawer_.draw(scene(), render_settings_, frame_));
  drawer_.cpu().draw_overlay(*overlay_, frame_, stats);
  return stats;
}

}  // namespace temblor::app
