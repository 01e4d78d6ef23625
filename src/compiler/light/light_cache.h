// The light cache: what the light stage found out by tracing rays, kept so that the next run traces only what
// is new. After a lamp was moved, those are the rays of that lamp; after its brightness or color was changed,
// almost none.
#pragma once

#include <cstdint>
#include <vector>

#include "base/bytes.h"
#include "base/result.h"
#include "compiler/light/faces/face_light.h"
#include "math/vec.h"

namespace temblor::compiler {

// A plain value; an empty one knows nothing. light_level() fills it and uses whatever is still valid. The
// light is the same, byte for byte, with any cache. Takes about 15 MB for a level with 200,000 luxels and
// 2,600 lights.
struct LightCache {
  // The cached data of one light map.
  struct Map {
    base::ByteVector shadows;     // from a ShadowWriter
    std::vector<float> dirt;      // by luxel; empty: dirt was off
    std::vector<LightLayer> sky;  // the light of suns and domes
    bool operator==(const Map&) const = default;
  };

  std::uint64_t geometry = 0;          // hash of what rays meet and of the sample points; 0: empty
  std::uint64_t dirt = 0;              // hash of the dirt settings
  std::uint64_t sky = 0;               // hash of the suns and domes
  std::vector<math::Vec3> lights;      // origins; shadow records refer to lights by index
  std::vector<Map> maps;               // by light map of the level
  std::vector<std::uint32_t> bounces;  // BounceRays::seen (bounce.h); empty: nothing bounced
  bool operator==(const LightCache&) const = default;
};

// Returns the same bytes for equal caches. The format is described in the source file.
base::ByteVector write_light_cache(const LightCache& cache);

// Fails with kUnsupported for another version of the format and with kMalformed if the bytes are damaged. A
// cache of another level is read, and ignored when it is used. The contents are trusted: a forged cache gives
// wrong light, but does no other harm.
base::Result<LightCache> read_light_cache(base::Bytes bytes);

}  // namespace temblor::compiler
