// `temblor render`: pictures and films of a level or a recording, without a display.
#pragma once

#include <optional>
#include <string>

#include "app/commands/options.h"
#include "base/result.h"
#include "client/view/presentation.h"
#include "command/variables.h"
#include "render/renderer.h"
#include "render/scene.h"

namespace temblor::app {

class Command;

struct RenderOptions {
  std::string map;   // empty: the level made in code
  std::string demo;  // a recording in place of a level; empty: none
  FrameOptions frame{.size = {1280, 720}};
  render::Projection projection = render::Projection::kPerspective;
  std::optional<math::Vec3> position_world;
  std::optional<math::Vec3> angles_deg;
  double time_s = 0;
  std::optional<FrameRange> frame_range;  // nothing: one of a level, all of a recording
  int frames_per_second = 30;
  double turn_deg = 0;  // yaw from one frame to the next
  bool stats = false;
  bool no_sound = false;
  std::string out;
};

Command* add_render_command(Command& program, RenderOptions& io_options);

base::Status run_render(const RenderOptions& options, const GameFolders& folders,
                        const client::PresentationSettings& presentation, const render::Settings& settings);

}  // namespace temblor::app
