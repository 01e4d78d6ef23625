// What the keys of brush entities ask of the light on their faces.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/build/draft.h"
#include "formats/levels/bsp.h"
#include "formats/levels/entities.h"

namespace temblor::compiler {

// The keys of worldspawn, a func_group, a func_detail or a brush entity. Unknown keys and values that are no
// numbers count as missing. Brush entities that the game moves about cast a shadow only if they ask for it.
SurfaceKeys surface_keys_of(const formats::Entity& entity);

struct FaceKeys {
  std::vector<SurfaceKeys> keys;       // at least one
  std::vector<std::uint32_t> of_face;  // by face, into keys
};

// For a finished level, which no longer knows its brushes: each model's faces have the keys of the entity
// that shows it ("model" "*3").
FaceKeys face_keys_of(const formats::Bsp& bsp, std::span<const formats::Entity> entities);

}  // namespace temblor::compiler
