// The gun in the player's hand, for effects at its barrel.
#pragma once

#include <optional>

#include "client/debris/shots.h"
#include "client/session/client_state.h"
#include "client/session/model_table.h"
#include "client/view/view.h"

namespace temblor::client {

// Returns where the picture shows the barrel of the view model; nothing if it shows none. The view model has
// a field of view of its own (`weapon_fov_deg`; 0: the camera's), so a point of it is moved to where the
// camera's field of view would show it at the same pixel.
std::optional<HeldGun> find_held_gun(const Game& game, const ModelTable& models, const PlayerView& view,
                                     float weapon_fov_deg, bool prefers_md5);

}  // namespace temblor::client
