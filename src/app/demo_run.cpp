#include "app/demo_run.h"

#include <utility>

namespace temblor::app {

using base::ErrorCode;

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
  while (run.player_.state().game().signon < 4) {
    TRY(const bool goes_on, run.advance_by_packet());
    if (goes_on) continue;
    base::Error error = base::error(ErrorCode::kMalformed, "the recording ends before a game has begun");
    error.file = demo.name;
    return error;
  }
  run.first_time_s_ = run.time_s_;
  return run;
}

base::Status DemoRun::present() {
  client::ClientState& state = player_.state();
  return presentation_->advance(state, time_s_, player_.view_angles_at(time_s_), presentation_settings_);
}

base::Result<bool> DemoRun::advance_to(double time_s) {
  TRY(const bool goes_on, player_.advance_to(time_s));
  time_s_ = time_s;
  TRY_STATUS(present());
  return goes_on;
}

base::Result<bool> DemoRun::advance_by_packet() {
  TRY(const bool goes_on, player_.read_packet());
  time_s_ = player_.state().time_s();
  TRY_STATUS(present());
  return goes_on;
}

render::FrameStats DemoRun::draw() {
  render::FrameStats stats = renderer_.render(presentation_->scene(), render_settings_, frame_);
  const render::DrawList& list =
      presentation_->draw_list(player_.state(), frame_.width(), frame_.height(), presentation_settings_);
  renderer_.draw_overlay(list, frame_, stats);
  return stats;
}

}  // namespace temblor::app
