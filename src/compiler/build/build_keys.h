// Tells whether a stage would make what it made before.
#pragma once

#include "compiler/build.h"
#include "compiler/light/light_level.h"
#include "compiler/make_draft.h"
#include "formats/levels/map.h"

namespace temblor::compiler {

// Of the BSP stage: all brushes, and what their entities say of them; of entities without brushes nothing, as
// long as the level does not leak.
StageKey key_of_brushes(const formats::Map& map, TextureSize texture_size, const DraftOptions& options);

// Of the places of entities within what is solid, which the BSP stage does not take for outside. Where an
// entity goes into or out of solid, a leak may come or go. That is asked of each hull whose outside may be
// larger than that of what is drawn; the level leaks in none of them.
StageKey key_of_solid_occupants(const formats::Map& map, const formats::Bsp& bsp);

// Of the light stage. `bsp`: with visibility, if it shall have any; what light it has does not count.
// Entities count if they are lights, if they have brushes, or if a spotlight might aim at them.
StageKey key_of_light(const formats::Bsp& bsp, const std::vector<formats::Entity>& entities,
                      const FaceKeys& face_keys, const LightOptions& options);

}  // namespace temblor::compiler
