// Plays a demo and draws its frames: a DemoPlayback with a renderer.
#pragma once

#include <string>
#include <vector>

#include "app/commands/options.h"
#include "app/demo/demo_loading.h"
#include "app/demo/demo_playback.h"
#include "app/level/scene_drawer.h"
#include "base/result.h"
#include "client/view/presentation.h"

namespace temblor::app {

class DemoRun {
 public:
  // `demo` must outlive it. Plays until the level is loaded and the game has started. Fails if the level is
  // missing, the demo has no game, or the renderer of `frame` cannot be used.
  static base::Result<DemoRun> start(const LoadedDemo& demo, const FrameOptions& frame,
                                     const client::PresentationSettings& presentation,
                                     const render::Settings& settings);

  // See DemoPlayback.
  base::Result<bool> advance_to(double time_s);
  base::Result<bool> advance_by_packet();

  // Draws with other stages from now on (render::Renderer::replace_stages).
  void replace_stages(const render::FrameStages& stages) { drawer_.cpu().replace_stages(stages); }

  // Result of the last advance. Valid until the next one.
  const render::Scene& scene() const { return playback_.presentation().scene(); }
  // Does the work that happens once per level or session, such as allocating buffers: the next frames take as
  // long as they do in the middle of a game.
  base::Status warm_up();
  // Draws the scene with the status bar and texts on it. Fails only with OpenGL.
  base::Result<render::FrameStats> draw();
  const render::FrameBuffer& frame() const { return frame_; }
  render::FrameBuffer& frame() { return frame_; }
  // Returns the problems since the last call, such as missing models, one line each.
  std::vector<std::string> take_notes() { return playback_.presentation().take_notes(); }

 private:
  DemoRun(DemoPlayback playback, SceneDrawer drawer, const FrameOptions& frame,
          const render::Settings& settings);
  void lay_out_overlay();

  DemoPlayback playback_;
  // Status bar and texts of the last advance; the presentation owns them.
  const render::DrawList* overlay_ = nullptr;
  render::Settings render_settings_;
  SceneDrawer drawer_;
  render::FrameBuffer frame_;
};

}  // namespace temblor::app
