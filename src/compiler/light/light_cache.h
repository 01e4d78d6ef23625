// What light found out by rays, kept so that the next run asks only what is new: after a lamp was moved, the
// rays of that lamp; after it was made brighter or another color, next to none.
#pragma once

#include <cstdint>
#include <vector>

#include "base/bytes.h"
#include "base/result.h"
#include "compiler/light/faces/face_light.h"
#include "math/vec.h"

namespace temblor::compiler {

// A value; an empty one knows nothing. light_level (light_level.h) fills it and uses what of it still holds:
// light is the same, byte for byte, with any cache that it ever filled. About 15 MB for a level of 200,000
// luxels and 2,600 lights.
struct LightCache {
  struct Map {
    base::ByteVector shadows;     // a ShadowWriter's
    std::vector<float> dirt;      // by luxel; empty: none was asked for
    std::vector<LightLayer> sky;  // what comes from suns and domes
    bool operator==(const Map&) const = default;
  };

  std::uint64_t geometry = 0;      // a hash of all that rays meet, and of where light is measured; 0: empty
  std::uint64_t dirt = 0;          // a hash of what was asked of dirt
  std::uint64_t sky = 0;           // and of suns and domes
  std::vector<math::Vec3> lights;  // where they stand: a record of shadows names them by number
  std::vector<Map> maps;           // by light map of the level
  std::vector<std::uint32_t> bounces;  // a trace_bounces' (light/bounce.h); empty: nothing bounced
  bool operator==(const LightCache&) const = default;
};

// The same bytes for equal caches. The format is in the source file.
base::ByteVector write_light_cache(const LightCache& cache);

// kUnsupported when the bytes are of another version, kMalformed when they are damaged. Whether a cache is
// that of a level is found out when it is used: what is of another level is forgotten. What is read is taken
// on trust: a cache made up with the right hashes gives wrong light, though nothing worse.
base::Result<LightCache> read_light_cache(base::Bytes bytes);

}  // namespace temblor::compiler
