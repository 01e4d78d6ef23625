// Reads what the keys of a Half-Life level's brush entities say about their models.
#pragma once

#include <span>
#include <vector>

#include "world/level.h"

namespace temblor::world {

// Returns an element for each of `model_count` models. Models without an entity have the defaults. If several
// entities share a model, the first one counts.
std::vector<BrushEntity> read_brush_entities(std::span<const formats::Entity> entities,
                                             std::size_t model_count);

}  // namespace temblor::world
