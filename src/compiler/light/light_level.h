// The light stage: computes the light maps of a level's faces from the lights among its entities (light in
// Quake's own tools). Keys and formulas are those of ericw-tools' light, as far as its documentation
// describes them.
//
//   entities -> lights, suns, settings      faces -> luxel grids -> sample points
//        \______________________________________________/
//                                |
//         direct light with shadows (Embree) -> bounces -> styles and bytes
//
// Embree traces the rays; check_light() says whether it is available.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "base/bytes.h"
#include "base/parallel_for.h"
#include "base/result.h"
#include "compiler/light/light_cache.h"
#include "compiler/light/surface_keys.h"
#include "compiler/report.h"
#include "compiler/world_keys.h"
#include "formats/images/palette.h"
#include "formats/levels/bsp.h"
#include "formats/levels/lit.h"
#include "math/vec.h"

namespace temblor::compiler {

// The mapper's options on the command line. The options of the level are in its entities.
struct LightOptions {
  // Shadow samples for each luxel along each axis: 1, 2 or 4 (shadows/shadow_filter.h).
  int extra = 1;
  bool fast = false;             // no dirt, no bounces, an eighth of the rays to the sky
  std::optional<int> bounces{};  // overrides the level's _bounce
  std::optional<bool> dirt{};    // overrides the level's _dirt
  WorldKeys world_keys{};        // override those of the level; see compiler/world_keys.h
  // Texels between the samples of all light maps of another scale, 1 to 128; overrides _lmscale.
  std::optional<int> luxel_texels{};
  std::optional<float> units_per_luxel{};  // overrides _world_units_per_luxel of all brushes; 0: off
  int soft = 0;                            // luxels on each side over which light is averaged
  int sky_rays = 128;                      // at most this many directions for a sky dome or a sun's penumbra
  bool hdr = false;                        // write LIGHTING_E5BGR9
  bool face_normals = false;               // write FACENORMALS
  bool directions = false;                 // write LIGHTINGDIR
  std::optional<math::Vec3> grid_step{};   // units between the samples of a light grid; nothing: no grid
  std::optional<formats::Palette> palette{};  // for _bouncecolorscale and tinted glass
};

// Counts for the mapper, and the colored light. Dark faces are those that may be lit but get no light.
struct LightSummary {
  std::size_t lights = 0, lit_faces = 0, dark_faces = 0;
  std::size_t samples = 0;  // gray samples of all styles
  bool colored = false;     // `lit` has samples, and the level has a BSPX lump RGBLIGHTING
  formats::Lit lit;
};

// Lights a level: sets styles and light_offset of every face, `lighting`, RGBLIGHTING if any light has a
// color, LMSHIFT or DECOUPLED_LM for light maps of other resolutions (faces/light_maps.h), and
// LIGHTGRID_OCTREE, LIGHTING_E5BGR9, LIGHTINGDIR, and FACENORMALS if the options ask for them. Replaces any
// earlier light. Writes the "style" of switchable lights into the entity text. Visibility makes this faster,
// but does not change the result; neither does the number of threads.
//
// Fails if the entity text does not parse, if faces are invalid, if `progress` stops it (kUsage), or if
// Embree is missing or out of memory; level and cache are then unchanged.
//
// `io_cache`: what earlier runs found out; used and updated. null: nothing is kept. The light is the same
// either way.
base::Result<LightSummary> light_level(formats::Bsp& io_bsp, const FaceKeys& face_keys,
                                       const LightOptions& options, base::Jobs& io_jobs, Progress progress,
                                       Warnings& io_warnings, LightCache* io_cache = nullptr);

// Fails with kUnsupported if no level can be lit because Embree is missing or does not run on this machine.
// Lets a program fail before the long stages that come first.
base::Status check_light();

// For several processes that share the work: shard `index` of `count` is light maps and faces index, index +
// count, ...; one process merges all shards into what light_level() would have made.
struct LightShard {
  std::uint32_t index = 0, count = 1;  // index < count
};
struct LightShardBytes {
  base::ByteVector bytes;
  bool is_finished = false;  // false: `progress` stopped it; `bytes` can be continued
};
// Makes a shard. `begun`: earlier bytes of the same shard, to continue; empty or anything else: start over.
// The finished bytes do not depend on how often the work was stopped.
base::Result<LightShardBytes> light_shard(const formats::Bsp& bsp, const FaceKeys& face_keys,
                                          const LightOptions& options, const LightShard& shard,
                                          base::Bytes begun, base::Jobs& io_jobs, Progress progress);

// The bytes of a shard, of light or of visibility, and the file that they come from.
struct NamedShard {
  base::Bytes bytes;
  std::string file{};  // for errors; empty: unknown
};

// Merges all shards, in any order. Fails with kUsage if one is missing, duplicate or unfinished, or belongs
// to another level, other lights or other options.
base::Result<LightSummary> merge_light(formats::Bsp& io_bsp, const FaceKeys& face_keys,
                                       const LightOptions& options, std::span<const NamedShard> shards,
                                       base::Jobs& io_jobs, Warnings& io_warnings);

}  // namespace temblor::compiler
