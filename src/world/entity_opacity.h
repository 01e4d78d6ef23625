// The opacity that the keys of an entity give its model.
#pragma once

#include <optional>

#include "formats/levels/entities.h"

namespace temblor::world {

// The opacity, 0 (invisible) to 1, by the keys "rendermode" and "renderamt" of Half-Life. Nothing for
// entities that are drawn as usual: modes 0 (normal) and 4 (only alpha-tested). Modes 1 (color), 2 (texture),
// 3 (glow), and 5 (additive) get the same; BrushEntity has the rest of modes 1 and 5.
std::optional<float> find_half_life_opacity(const formats::Entity& entity);

// The opacity, 0 to 1, by the key "alpha": 0 or no number is 1, and numbers below 0 are invisible. In levels
// of Half-Life, its own keys come first.
float find_opacity(const formats::Entity& entity, bool is_half_life);

}  // namespace temblor::world
