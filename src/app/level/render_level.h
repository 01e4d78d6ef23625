// `temblor render --map`: renders a level as pictures or a film.
//
//   without --entities: level ---------------------> LevelScene ----+
//   with --entities:    level, game code, 1 s -----> RunningLevel --+--> still scene, camera -> frames ->
//   film
#pragma once

#include "app/commands/options.h"
#include "app/commands/render_command.h"
#include "base/result.h"

namespace temblor::app {

// Frames show the same moment of the level; only the camera turns by --turn from one to the next.
base::Status render_level(const RenderOptions& options, const GameFolders& folders,
                          const host::HostVariables& settings);

}  // namespace temblor::app
