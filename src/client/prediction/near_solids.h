// Which brush models a prediction looks at: a server may show thousands.
#pragma once

#include <cstddef>
#include <vector>

#include "client/prediction/predicted_player.h"

namespace temblor::client {

// Leaves the `most` whose boxes are nearest to the place, in order of entity. One that is nowhere (its origin
// is no number) is farther than any other.
void keep_nearest(std::vector<SolidModel>& io_solids, const world::Level& level,
                  const math::Vec3& place_world, std::size_t most);

}  // namespace temblor::client
