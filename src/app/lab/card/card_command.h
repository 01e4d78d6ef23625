// `temblor lab card`: caches of surfaces in the memory of the graphics card, large and small.
#pragma once

#include <string>

#include "app/commands/options.h"
#include "app/lab/card/card_figures.h"
#include "base/result.h"
#include "client/view/presentation.h"
#include "render/settings.h"

namespace temblor::app {

class Command;

constexpr const char* kCardName = "card";

struct CardOptions {
  std::string map, demo;  // without either, the small built-in level
  CardGrid grid;
  bool json = false;
};

Command* add_card_command(Command& lab, CardOptions& io_options);

// Prints the figures. Errors: no OpenGL, or a level or demo that cannot be loaded.
base::Status run_card(const CardOptions& options, const GameFolders& folders,
                      const client::PresentationSettings& presentation, const render::Settings& settings);

}  // namespace temblor::app
