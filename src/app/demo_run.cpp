#include "app/demo_run.h"

#include <utility>

namespace temblor::app {

DemoRun::DemoRun(const LoadedDemo& demo, client::DemoPlayer player, const FrameOptions& frame,
                 const client::PresentationSettings& presentation, const render::Settings& settings)
    : player_(std::move(player)),
      presentation_(std::make_unique<client::Presentation>(demo.library)),
      presentation_settings_(presentation),
      render_settings_(settings),
      renderer_(demo.look.palette, demo.look.colormap),
      frame_(frame.size.width, frame.size.height, frame.format) {
  presentation_settings_.view.fov_deg = frame.fov_deg;
}

base::Result<DemoRun> DemoRun::start(const LoadedDemo& demo, const FrameOptions& frame,
                                     const client::PresentationSettings& presentation,
                                     const render::Settings& settings) {
  TRY(client::DemoPlayer player, client::DemoPlayer::open(demo.bytes, demo.name));
  DemoRun run(demo, std::move(player), frame, presentation, settings);
  TRY_STATUS(run.advance_by_packet());
  return run;
}

math::Vec3 DemoRun::view_angles_deg() const {
  return player_.view_angles_at(player_.server_time_s(),
                                {.interpolate = presentation_settings_.interpolate, .no_lerp_models = {}});
}

base::Status DemoRun::present() {
  TRY_STATUS(presentation_->advance(player_.state(), player_.server_time_s(), view_angles_deg(),
                                    presentation_settings_));
  overlay_ =
      &presentation_->draw_list(player_.state(), frame_.width(), frame_.height(), presentation_settings_);
  return base::Ok{};
}

base::Status DemoRun::pass() {
  return presentation_->pass(player_.state(), player_.server_time_s(), view_angles_deg(),
                             presentation_settings_);
}

// Every packet between is lived through from its beginning to its end.
base::Result<bool> DemoRun::advance_to(double time_s) {
  while (player_.packet_time_s() < time_s) {
    TRY_STATUS(player_.advance_to(player_.packet_time_s()));
    TRY_STATUS(pass());
    TRY(const bool goes_on, player_.begin_packet());
    if (!goes_on) break;
    TRY_STATUS(pass());
  }
  TRY(const bool goes_on, player_.advance_to(time_s));
  TRY_STATUS(present());
  return goes_on;
}

base::Result<bool> DemoRun::advance_by_packet() {
  TRY(const bool goes_on, player_.read_packet());
  TRY_STATUS(present());
  return goes_on;
}

render::FrameStats DemoRun::draw() {
  render::FrameStats stats = renderer_.render(presentation_->scene(), render_settings_, frame_);
  renderer_.draw_overlay(*overlay_, frame_, stats);
  return stats;
}

}  // namespace temblor::app
