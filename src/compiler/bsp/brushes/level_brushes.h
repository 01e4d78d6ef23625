// Reads the brushes of a map: sorts them into the level's models and finds out what fills each brush and what
// each side shows.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "compiler/bsp/brushes/brush.h"
#include "compiler/bsp/draft.h"
#include "compiler/bsp/faces/faces.h"
#include "formats/levels/map.h"

namespace temblor::compiler {

// Everything that the BSP stage needs from the map. Indices refer to the lists in here.
struct LevelBrushes {
  PlaneSet planes;
  std::vector<Surface> surfaces;
  std::vector<std::string> textures;  // BspTexinfo::miptex is an index into it
  std::vector<SurfaceKeys> surface_keys;
  std::vector<std::vector<Brush>> models;   // the world first
  bool is_region = false;                   // only a part of the map
  std::vector<formats::Entity> entities;    // of the level, in order
  std::vector<BrushEntity> brush_entities;  // for make_level_entities()
  // Origins of point entities, which the outside must not reach, and their numbers in the map.
  std::vector<math::Vec3d> occupants_world;
  std::vector<std::size_t> entity_of_occupant;
};

// Fails if the first entity is not worldspawn, if no brush of the world has a volume, or if the region
// brushes are wrong.
base::Result<LevelBrushes> sort_brushes(const formats::Map& map, TextureSize texture_size,
                                        Warnings& io_warnings);

}  // namespace temblor::compiler
