// `temblor render --demo`: renders a demo as pictures, a film, or a sound file.
//
//   scan the demo -> frame range -> sound, to a temporary .wav -> frames -> film
#pragma once

#include "app/commands/options.h"
#include "app/commands/render_command.h"
#include "base/result.h"
#include "client/view/presentation.h"
#include "render/renderer.h"

namespace temblor::app {

// Damage after the range is not an error. Damage inside it keeps what was rendered before it and returns the
// error.
base::Status render_demo(const RenderOptions& options, const GameFolders& folders,
                         const client::PresentationSettings& presentation, const render::Settings& settings);

}  // namespace temblor::app
