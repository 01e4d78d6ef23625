// The space battle in a window.
#pragma once

#include "app/lab/space_figures.h"
#include "base/result.h"
#include "platform/window.h"

namespace temblor::app {

// Opens a window and plays until the player leaves. Fails if there is no display.
base::Status play_space(const SpaceScene& scene);

// The same in a window that exists. Pictures have the window's size.
base::Status play_space_in(platform::Window& window, const SpaceScene& scene);

}  // namespace temblor::app
