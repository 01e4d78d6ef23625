// `temblor render`: pictures and films of a level or a demo, without a display. The name of the output
// selects the format (demo/film.h).
#pragma once

#include <optional>
#include <string>

#include "app/commands/options.h"
#include "base/result.h"
#include "host/host_variables.h"
#include "render/scene.h"

namespace temblor::app {

class Command;

struct RenderOptions {
  // Level name or .bsp file; empty: the small built-in level.
  std::string map;
  // Demo name or .dem file, rendered instead of a level; empty: none.
  std::string demo;
  // Draw everything that game code creates in a second of play.
  bool entities = false;
  // The game code for that; empty: progs.dat of the game directories.
  std::string program;
  // Which entities the level has; nothing: as the variable `skill` says.
  std::optional<int> skill;
  bool deathmatch = false;
  FrameOptions frame{.size = {1280, 720}};
  render::Projection projection = render::Projection::kPerspective;
  // Position of the camera; nothing: the level's start.
  std::optional<math::Vec3> position_world;
  // Pitch (positive down), yaw, and roll.
  std::optional<math::Vec3> angles_deg;
  // Time of the level, for animation. Nothing: the time of the running game, or 0.
  std::optional<double> time_s;
  // Nothing: one frame of a level, all frames of a demo.
  std::optional<FrameRange> frame_range;
  int frames_per_second = 30;
  // Added to the yaw from one frame of a level to the next.
  double turn_deg = 0;
  // Print describe_frame() of every frame.
  bool stats = false;
  // Leave the sound out of a film.
  bool no_sound = false;
  // File name or pattern.
  std::string out;
};

Command* add_render_command(Command& program, RenderOptions& io_options);

// Renders to `options.out`. Errors: a level or demo that cannot be loaded, a name that does not fit the
// options, game code that is missing or fails, or a file that cannot be written. A damaged demo is rendered
// up to the damage, which is then returned as an error.
base::Status run_render(const RenderOptions& options, const GameFolders& folders,
                        const host::HostVariables& settings);

}  // namespace temblor::app
