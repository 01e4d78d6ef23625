#include "compiler/build.h"

#include <utility>

#include "compiler/bsp/tree_portals.h"
#include "formats/levels/entities.h"

namespace temblor::compiler {

// The stage keys stay 0, so no stage mistakes what the level has for a result of its own.
base::Result<Build> make_build_from_level(formats::Bsp bsp, std::optional<formats::Lit> lit,
                                          bool water_is_transparent) {
  Build build;
  TRY(const std::vector<formats::Entity> entities, formats::read_entities(bsp.entities));
  TRY(build.portals, make_tree_portals(bsp, {water_is_transparent, Clusters::kSharedVisibility}));
  build.face_keys = find_face_keys(bsp, entities);
  build.own_textures = bsp.miptexes.size();
  build.water_is_transparent = water_is_transparent;
  build.bsp = std::move(bsp);
  build.lit = std::move(lit);
  return build;
}

}  // namespace temblor::compiler
