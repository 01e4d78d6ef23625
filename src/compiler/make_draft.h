// The BSP stage: from map text to a level that lacks visibility, light and textures.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/parallel_for.h"
#include "base/result.h"
#include "compiler/build/draft.h"
#include "compiler/report.h"
#include "formats/levels/map.h"

namespace temblor::compiler {

struct DraftOptions {
  bool water_is_transparent = true;  // to visibility
  double subdivide_texels = 240;  // of a lit face along its texture's axes; the most that engines of old draw
  bool fill_outside = true;
};

// How a level that is not closed leaks: from an entity to the outside.
struct LeakPath {
  std::size_t entity;                     // of the map
  std::uint32_t line;                     // of the entity, in the map's text
  std::string classname;                  // as much of it as a message can bear
  std::vector<math::Vec3d> points_world;  // the entity's place first
};

struct DraftResult {
  Draft draft;  // its textures are names without pictures
  std::optional<LeakPath> leak;
  bool clip_hulls_leak = false;  // where what is drawn does not: what seals is not in them (_hulls)
  bool is_region = false;        // only a part of the map is in it
};

// The same bytes whatever the number of threads. Errors: no worldspawn, no brush with a volume, a brush
// without sides. What `progress` returns is not asked: there is nothing to save.
base::Result<DraftResult> make_draft(const formats::Map& map, TextureSize texture_size,
                                     const DraftOptions& options, base::Jobs& jobs, Warnings& io_warnings,
                                     Progress progress = kNobodyWatches);

}  // namespace temblor::compiler
