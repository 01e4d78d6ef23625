// Keys that tell whether a stage would make what it made before: hashes of everything that the stage reads.
#pragma once

#include "compiler/bsp/make_draft.h"
#include "compiler/build.h"
#include "compiler/light/light_level.h"
#include "formats/levels/map.h"

namespace temblor::compiler {

// The key of the BSP stage: all brushes, and the keys of their entities. Point entities matter only for
// leaks, and results with a leak are never reused.
StageKey make_brushes_key(const formats::Map& map, TextureSize texture_size, const DraftOptions& options);

// A hash of the origins of entities that are inside solid, which the flood from outside ignores. If an entity
// moves into or out of solid, a leak may come or go. Each hull whose outside may be larger than that of the
// drawn hull is checked; `bsp` leaks in none of them.
StageKey make_solid_occupants_key(const formats::Map& map, const formats::Bsp& bsp);

// The key of the light stage. `bsp` has its final visibility; light that it already has does not matter.
// Entities matter if they are lights, have brushes, or might be the target of a spotlight.
StageKey make_light_key(const formats::Bsp& bsp, const std::vector<formats::Entity>& entities,
                        const FaceKeys& face_keys, const LightOptions& options);

}  // namespace temblor::compiler
