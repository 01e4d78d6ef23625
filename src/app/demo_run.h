// A recording being played: state, presentation and renderer, moment by moment.
#pragma once

#include <memory>

#include "app/demo_loading.h"
#include "app/options.h"
#include "base/result.h"
#include "client/demo_player.h"
#include "client/presentation.h"
#include "render/renderer.h"

namespace temblor::app {

class DemoRun {
 public:
  // `demo` must outlive it. Plays on until the level is there and the game has begun; fails when that does
  // not come about: a level that is not there, a recording without a game.
  static base::Result<DemoRun> start(const LoadedDemo& demo, const FrameOptions& frame,
                                     const client::PresentationSettings& presentation,
                                     const render::Settings& settings);

  // Plays on to `time_s` of the recording's clock. False: the recording has ended. What happens on the way
  // does so at its own time, however long the way is.
  base::Result<bool> advance_to(double time_s);
  // Plays on by one packet, to its time.
  base::Result<bool> advance_by_packet();

  // What the last advance led to. Valid until the next one.
  const render::Scene& scene() const { return presentation_->scene(); }
  // Draws it, with everything on it.
  render::FrameStats draw();
  const render::FrameBuffer& frame() const { return frame_; }
  render::FrameBuffer& frame() { return frame_; }
  std::vector<std::string> take_notes() { return presentation_->take_notes(); }

 private:
  DemoRun(const LoadedDemo& demo, client::DemoPlayer player, const FrameOptions& frame,
          const client::PresentationSettings& presentation, const render::Settings& settings);
  math::Vec3 view_angles_deg() const;
  base::Status present();
  base::Status pass();

  client::DemoPlayer player_;
  std::unique_ptr<client::Presentation> presentation_;  // parts of it refer to one another
  const render::DrawList* overlay_ = nullptr;           // its last
  client::PresentationSettings presentation_settings_;
  render::Settings render_settings_;
  render::Renderer renderer_;
  render::FrameBuffer frame_;
};

}  // namespace temblor::app
