// A recording being played and drawn, moment by moment.
#pragma once

#include <string>
#include <vector>

#include "app/commands/options.h"
#include "app/demo/demo_loading.h"
#include "app/demo/demo_playback.h"
#include "base/result.h"
#include "client/view/presentation.h"
#include "render/renderer.h"

namespace temblor::app {

class DemoRun {
 public:
  // `demo` must outlive it. Plays on until the level is there and the game has begun; fails when that does
  // not come about: a level that is not there, a recording without a game.
  static base::Result<DemoRun> start(const LoadedDemo& demo, const FrameOptions& frame,
                                     const client::PresentationSettings& presentation,
                                     const render::Settings& settings);

  // As those of DemoPlayback.
  base::Result<bool> advance_to(double time_s);
  base::Result<bool> advance_by_packet();

  // What the last advance led to. Valid until the next one.
  const render::Scene& scene() const { return playback_.presentation().scene(); }
  // Draws it, with everything on it.
  render::FrameStats draw();
  const render::FrameBuffer& frame() const { return frame_; }
  render::FrameBuffer& frame() { return frame_; }
  std::vector<std::string> take_notes() { return playback_.presentation().take_notes(); }

 private:
  DemoRun(const LoadedDemo& demo, DemoPlayback playback, const FrameOptions& frame,
          const render::Settings& settings);
  void lay_over();

  DemoPlayback playback_;
  const render::DrawList* overlay_ = nullptr;  // the presentation's last
  render::Settings render_settings_;
  render::Renderer renderer_;
  render::FrameBuffer frame_;
};

}  // namespace temblor::app
