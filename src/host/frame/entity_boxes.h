// The boxes of the local server's entities, from the server to the presentation (r_showbboxes).
#pragma once

#include "client/view/presentation.h"

namespace temblor::host {

struct Host;

// Fills in PresentationSettings::boxes if the player wants them. Only a single-player game has them: in any
// other game they are unknown here, or would be a cheat. The console says so, once until the player turns
// them off. Call it while no tick is played.
void update_entity_boxes(Host& io_host, client::PresentationSettings& io_settings);

}  // namespace temblor::host
