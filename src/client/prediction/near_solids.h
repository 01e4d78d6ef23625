// Limits the brush models that a prediction traces through, as a server may show thousands. Only near ones
// can stop a player within the few ticks of a prediction.
#pragma once

#include <cstddef>
#include <vector>

#include "client/prediction/predicted_player.h"

namespace temblor::client {

// Keeps the `max_count` models whose boxes are nearest to a point, sorted by entity. A model whose origin is
// not a number counts as farthest.
void keep_nearest(std::vector<SolidModel>& io_solids, const world::Level& level,
                  const math::Vec3& place_world, std::size_t max_count);

}  // namespace temblor::client
