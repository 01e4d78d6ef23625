// Shapes that the local server's game code draws, from the server to the presentation (ex_draw_line() and
// others).
#pragma once

#include "client/view/presentation.h"

namespace temblor::host {

struct Host;

// Fills in PresentationSettings::lines and texts; empty for demos and games on other servers, which have
// none. Call it while no tick is played.
void update_debug_shapes(const Host& host, client::PresentationSettings& io_settings);

}  // namespace temblor::host
