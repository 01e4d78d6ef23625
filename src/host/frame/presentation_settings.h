// The presentation settings of a frame. Most come from variables; a few (zoom, scoreboard, hint for a dead
// player) follow from the state of the host.
#pragma once

namespace temblor::host {

struct Host;

// Sets HostVideo::presentation_settings for this frame. Call it before the presentation is advanced.
void update_presentation_settings(Host& io_host);

}  // namespace temblor::host
