// A level made in code, for machines and tests without game data: a hall with pillars, a corridor with a
// door, stairs down to a court under the sky with a pool, and a dim cellar; every kind of face and texture
// that the engine knows. The same bytes for the same options.
#pragma once

#include <cstdint>
#include <vector>

#include "formats/levels/bsp.h"
#include "math/vec.h"

namespace temblor::artgen {

struct SmallLevelOptions {
  bool pvs = true;
  bool light = true;
  bool four_styles = false;            // the cellar's faces have four light styles each
  bool wide_faces = false;             // two texels a unit, lit faces of up to 1024 texels
  bool edge_used_three_times = false;  // as some compilers' levels: faces share edges without limit
  bool missing_texture = false;        // the hall's bricks are named by the level but not in it
  bool colored_light = false;          // with the BSPX lump RGBLIGHTING
  bool tiny = false;                   // one room with textures of 16 texels: under 20 KB as a file
  std::uint64_t seed = 1;              // of the noise in the textures
};

// Satisfies everything in formats/levels/bsp_validate.h; fits version 29. Model 0 is the world, model 1 a
// door.
formats::Bsp make_small_level(const SmallLevelOptions& options = {});

// The shape of that level's world: solid everywhere but for these boxes, later ones over earlier ones.
struct SmallLevelBox {
  math::Bounds bounds;
  std::int32_t contents;  // as in BspLeaf
};
std::vector<SmallLevelBox> small_level_boxes(const SmallLevelOptions& options = {});
math::Bounds small_level_door(const SmallLevelOptions& options = {});

}  // namespace temblor::artgen
