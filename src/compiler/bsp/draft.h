// The output of the BSP stage: a level that lacks only visibility, light and the pixels of its textures.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/function_ref.h"
#include "compiler/light/surface_keys.h"
#include "compiler/vis/portals.h"
#include "formats/levels/bsp.h"

namespace temblor::compiler {

// Returns a texture's width and height in texels. The BSP stage needs them because some texture alignments
// are measured in whole textures.
using TextureSize = base::FunctionRef<math::Vec2d(std::string_view name)>;

// The result for a map entity that has brushes, or that has the class of one (func_group).
struct BrushEntity {
  bool is_in_level = false;  // false: it was merged into the world, or has no brush with a volume
  std::string model;         // "*1", ...; empty: the world
  std::string origin;        // the center of its origin brush; empty: its "origin" key stays
  bool operator==(const BrushEntity&) const = default;
};

// Textures in `bsp` are names without pixels; level_textures.h fills them in.
struct Draft {
  formats::Bsp bsp;  // without visibility; unlit: styles 255, offsets -1
  PortalSet portals;
  std::vector<SurfaceKeys> surface_keys;    // at least one
  std::vector<std::uint32_t> keys_of_face;  // by face, into surface_keys
  std::vector<BrushEntity> brush_entities;  // in the order of the map
};

}  // namespace temblor::compiler
