// `temblor render --demo`: a recording as pictures or film.
#pragma once

#include "app/commands/options.h"
#include "app/commands/render_command.h"
#include "base/result.h"
#include "client/view/presentation.h"
#include "render/renderer.h"

namespace temblor::app {

base::Status render_demo(const RenderOptions& options, const GameFolders& folders,
                         const client::PresentationSettings& presentation, const render::Settings& settings);

}  // namespace temblor::app
