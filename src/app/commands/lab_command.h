// `temblor lab`: the laboratory, which runs the techniques of Abrash's articles side by side.
//
//   lab list                 the techniques
//   lab run TECHNIQUE        one technique against the engine: figures, and a picture
//   lab run space            the space battle, which needs no level
//   lab compare TECHNIQUES   a table of several techniques
//   lab book                 pages about all of them
//   lab school               lessons for beginners
//   lab replay FILE          a lockstep game, simulated again
//   lab wire                 how a game's state gets to its players
//   lab card                 ways to draw levels with a graphics card
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/commands/options.h"
#include "app/lab/card/card_command.h"
#include "app/lab/model_crowd.h"
#include "app/lab/replay_command.h"
#include "app/lab/space_command.h"
#include "app/lab/wire/wire_command.h"
#include "base/result.h"
#include "client/view/presentation.h"
#include "render/settings.h"

namespace temblor::app {

class Command;

struct LabOptions {
  // "NAME" or "NAME:PARAMETER=VALUE,...", or kSpaceName.
  std::string technique;                // run
  std::vector<std::string> techniques;  // compare
  // Level name or .bsp file, or a demo; without either, the small built-in level.
  std::string map, demo;
  std::optional<math::Vec3> position_world, angles_deg;
  // Models before the camera, in place of the world.
  CrowdOptions models;
  FrameOptions frame{.size = {1280, 720}};
  // Angle between two measured views of a level.
  double step_deg = 30;
  // Measurements of each technique, in turns; the fastest counts.
  int rounds = 1;
  SpaceOptions space;
  ReplayOptions replay;
  WireOptions wire;
  CardOptions card;
  bool json = false;
  // Picture file of `run`; empty: none. Folder of `book` and `school`.
  std::string out;
  // Levels of `book`; empty: the small built-in level.
  std::vector<std::string> maps;
};

// The commands, to find the one that was given. The program owns them.
struct LabCommands {
  Command* lab = nullptr;
  Command* list = nullptr;
  Command* run = nullptr;
  Command* compare = nullptr;
  Command* book = nullptr;
  Command* school = nullptr;
  Command* replay = nullptr;
  Command* wire = nullptr;
  Command* card = nullptr;
};

LabCommands add_lab_command(Command& program, LabOptions& io_options);

// Errors: an unknown technique or parameter, a level or demo that cannot be loaded, a picture or page
// that cannot be written.
base::Status run_lab(const LabCommands& commands, const LabOptions& options, const GameFolders& folders,
                     const client::PresentationSettings& presentation, const render::Settings& settings);

}  // namespace temblor::app
