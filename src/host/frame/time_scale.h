// The speed of the game's time (host_timescale).
#pragma once

namespace temblor::host {

struct Host;

// Returns the factor by which game time runs faster than real time: as the player wants it in demos and in
// games without other players, otherwise 1. The console says why it is ignored, once until the player sets it
// back.
double choose_time_scale(Host& io_host);

}  // namespace temblor::host
