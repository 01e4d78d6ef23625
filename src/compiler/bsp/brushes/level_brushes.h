// The brushes of a map, sorted into the level's models, with what their sides show.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "compiler/bsp/brushes/brush.h"
#include "compiler/bsp/faces/faces.h"
#include "compiler/build/draft.h"
#include "formats/levels/map.h"

namespace temblor::compiler {

struct LevelBrushes {
  PlaneSet planes;
  std::vector<Surface> surfaces;
  std::vector<std::string> textures;  // a texinfo's miptex is a place in it
  std::vector<SurfaceKeys> surface_keys;
  std::vector<std::vector<Brush>> models;   // the world first
  bool is_region = false;                   // a part of the map, which lacks some of its entities
  std::vector<formats::Entity> entities;    // what goes into the level
  std::vector<BrushEntity> brush_entities;  // as level_entities() takes them
  // Points that must not be reached from outside, and of which entity of the map.
  std::vector<math::Vec3d> occupants_world;
  std::vector<std::size_t> entity_of_occupant;
};

base::Result<LevelBrushes> sort_brushes(const formats::Map& map, TextureSize texture_size,
                                        Warnings& io_warnings);

}  // namespace temblor::compiler
