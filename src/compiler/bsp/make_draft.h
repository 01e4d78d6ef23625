// The BSP stage: turns brushes into trees, faces and portals (qbsp in Quake's own tools).
//
// For each model and each of its three hulls (four for Half-Life):
//
//   brushes -> first tree -> portals -> fill outside -> faces -> second tree -> merge, subdivide ->
//   LevelWriter
//
// The first tree is cut by every side of every brush. It says what is solid where, so the outside can be
// filled and the visible parts of sides can be found. The second tree is cut only where something changes,
// which makes it far smaller. The method is that of constructive solid geometry by BSP trees (Thibault and
// Naylor, "Set operations on polyhedra using binary space partitioning trees", 1987); brush classes and keys
// follow ericw-tools' documentation.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/parallel_for.h"
#include "base/result.h"
#include "compiler/bsp/draft.h"
#include "compiler/report.h"
#include "formats/levels/map.h"

namespace temblor::compiler {

// The mapper's options for the BSP stage.
struct DraftOptions {
  bool water_is_transparent = true;  // visibility sees through the surfaces of liquids
  double subdivide_texels = 240;     // longest side of a lit face; original engines draw no more
  bool fill_outside = true;          // false: keep the faces outside a sealed level
  bool clip_hulls = true;            // false: leave them empty, so nothing stops players
  bool brush_list = false;           // write the BSPX lump BRUSHLIST
  bool half_life = false;            // clip hulls for Half-Life's boxes (version 30)
};

// A draft and what it says about the map.
struct DraftResult {
  Draft draft;  // its textures have names but no pixels
  std::optional<LeakPath> leak;
  bool clip_hulls_leak = false;  // though the drawn hull is sealed: a sealing brush is not in them (_hulls)
  bool is_region = false;        // only a part of the map was compiled (region brushes)
};

// Compiles a map. The result does not depend on the number of threads. Fails if the first entity is not
// worldspawn, if no brush of the world has a volume, or if there is more than one region brush. Cannot be
// stopped: the result of `progress` is ignored.
base::Result<DraftResult> make_draft(const formats::Map& map, TextureSize texture_size,
                                     const DraftOptions& options, base::Jobs& jobs, Warnings& io_warnings,
                                     Progress progress = kIgnoreProgress);

}  // namespace temblor::compiler
