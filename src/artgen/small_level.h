// A small BSP level that is generated in code, for tests and for machines without game data: a hall with
// pillars, a corridor with a door, stairs down to a court with a sky and a pool, and a dim cellar. It
// contains every kind of face and texture that the engine supports. The same options produce the same bytes.
//
//   SmallLevelLayout: boxes, lights, entities (level/layout.h)
//     | make_grid: cells between axial planes (level/grid.h)
//   CellGrid
//     |-- build_grid_tree: nodes and leaves (level/grid_tree.h)
//     |     |-- find_faces, GridLighter: faces and light maps (level/grid_faces.h, level/grid_light.h)
//     |     '-- find_visible_leaves: the PVS (level/grid_visibility.h)
//     '-- grow_grid, build_grid_tree: clip hulls 1 to 3
//   formats::Bsp
//
// It shares no code with the level compiler, so that the renderer and the server can be tested without it.
// All planes are axial and all leaves are boxes, which keeps each step short.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "formats/levels/bsp.h"
#include "math/vec.h"

namespace temblor::artgen {

struct SmallLevelOptions {
  bool pvs = true;
  bool light = true;
  // Every face in the cellar has four light styles, the most that the format allows.
  bool four_styles = false;
  // Two texels per unit, and lit faces of up to 1024 texels: more than the original engine draws.
  bool wide_faces = false;
  // Faces share edges without limit, as in the output of some compilers. Otherwise at most two faces share an
  // edge.
  bool edge_used_three_times = false;
  // The level refers to the hall's brick texture but does not contain it.
  bool missing_texture = false;
  // Adds the BSPX lump RGBLIGHTING. Has no effect without `light`.
  bool colored_light = false;
  // One room with textures of 16 x 16 texels: less than 20 KB as a file.
  bool tiny = false;
  // Seeds the noise in the textures; changes nothing else.
  std::uint64_t seed = 1;
};

// The level passes all checks of formats/levels/bsp_validate.h and fits version 29 of the format. Model 0 is
// the world, model 1 a door.
formats::Bsp make_small_level(const SmallLevelOptions& options = {});
// The textures of the default level that have these names, and all frames of their animations. Ignores case,
// and names that the level does not have. Painting all of them takes most of the level's time.
std::vector<formats::BspMiptex> make_small_level_textures(std::span<const std::string_view> names);

// A box of the world's shape, for tests that compare the BSP with its definition. The world is solid except
// in these boxes; later boxes replace earlier ones where they overlap.
struct SmallLevelBox {
  math::Bounds bounds;
  std::int32_t contents;  // as in BspLeaf
};
std::vector<SmallLevelBox> small_level_boxes(const SmallLevelOptions& options = {});
// The closed door's bounds.
math::Bounds small_level_door(const SmallLevelOptions& options = {});

}  // namespace temblor::artgen
