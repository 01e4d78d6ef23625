// Light: from a level's geometry and the lights among its entities to the light maps on its faces.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "base/bytes.h"
#include "base/parallel_for.h"
#include "base/result.h"
#include "compiler/build/surface_keys.h"
#include "compiler/light/light_cache.h"
#include "compiler/report.h"
#include "formats/images/palette.h"
#include "formats/levels/bsp.h"
#include "formats/levels/lit.h"

namespace temblor::compiler {

// What the person at work asks for; what the level asks for is in its entities.
struct LightOptions {
  // Samples of a shadow for each sample of the light map, each way: 1, 2 or 4 (see light/shadow_filter.h).
  int extra = 1;
  bool fast = false;             // neither dirt nor bounces, an eighth of the rays to the sky
  std::optional<int> bounces{};  // instead of the level's own _bounce
  std::optional<bool> dirt{};    // instead of the level's own _dirt
  int sky_rays = 128;            // the most directions each for a dome of sky, or a sun's penumbra
  std::optional<formats::Palette> palette{};  // for _bouncecolorscale, which without it does nothing
};

struct LightSummary {
  std::size_t lights = 0, lit_faces = 0, dark_faces = 0;
  std::size_t samples = 0;  // bytes of gray light
  bool colored = false;     // `lit` then has samples, and the level the BSPX lump RGBLIGHTING
  formats::Lit lit;
};

// Fills styles and light_offset of every face, `lighting`, and RGBLIGHTING where any light has a color;
// throws away whatever light there was. Gives switchable lights their "style" in the entity text. A level
// with visibility is lit faster, and alike. The bytes do not depend on the number of threads. Fails on entity
// text that does not parse, on faces that no level has, when `progress` says to stop (kUsage), and without
// Embree's memory; the level and the cache are then as they were.
//
// `io_cache`: what earlier runs found out, used and brought up to date; null: none is kept. The light is the
// same with any.
base::Result<LightSummary> light_level(formats::Bsp& io_bsp, const FaceKeys& face_keys,
                                       const LightOptions& options, base::Jobs& io_jobs, Progress progress,
                                       Warnings& io_warnings, LightCache* io_cache = nullptr);

// kUnsupported where no level can be lit: Embree is not on this machine, or does not run on it. Worth asking
// before what comes ahead of light.
base::Status check_light();

// The same work by several processes: each makes a shard, which is light maps and faces index, index + count,
// ..., and one of them merges all shards to what light_level would have made.
struct LightShard {
  std::uint32_t index = 0, count = 1;  // index < count
};
struct LightShardBytes {
  base::ByteVector bytes;
  bool is_finished = false;  // else `progress` said stop: to go on from
};
// `begun`: what was saved of this shard; empty, or of anything else: all of it is worked out. When it is
// finished the bytes are the same however often it was stopped.
base::Result<LightShardBytes> light_shard(const formats::Bsp& bsp, const FaceKeys& face_keys,
                                          const LightOptions& options, const LightShard& shard,
                                          base::Bytes begun, base::Jobs& io_jobs, Progress progress);

// `shards`: all of them, in any order. kUsage where one is missing, there twice, not finished, or of another
// level, other lights or other options.
base::Result<LightSummary> merge_light(formats::Bsp& io_bsp, const FaceKeys& face_keys,
                                       const LightOptions& options, std::span<const base::Bytes> shards,
                                       base::Jobs& io_jobs, Warnings& io_warnings);

}  // namespace temblor::compiler
