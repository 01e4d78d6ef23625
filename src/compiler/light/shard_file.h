// The share of one process in a level's light, as bytes: to be merged with others, or to be continued.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/bytes.h"
#include "base/result.h"
#include "compiler/light/bounce.h"
#include "compiler/light/faces/face_light.h"
#include "compiler/light/lit_level.h"

namespace temblor::compiler {

// Which share of which level the bytes are.
struct ShardHeader {
  std::uint64_t level = 0;  // hash of the level and of everything that its light depends on
  std::uint32_t index = 0, count = 1;
  bool operator==(const ShardHeader&) const = default;
};

// The light computed so far: direct light, and the rays of bounced light.
struct LightWork {
  std::vector<FaceLight> light;      // by light map (LitLevel::maps)
  std::vector<std::uint8_t> is_lit;  // by light map, 0 or 1
  BounceRays bounces;                // empty if no light bounces
};
// Returns light of which nothing is computed. `bounces`: whether light bounces.
LightWork begin_light(const LitLevel& lit, bool bounces);

// Which of `total` light maps or faces belong to a shard: index, index + count, ...
std::vector<std::uint32_t> list_share(const ShardHeader& shard, std::size_t total);

// Writes what is done of a shard. The bytes do not depend on how often the work was stopped.
base::ByteVector write_shard(const ShardHeader& header, const LightWork& work);

// The result of read_shard().
struct ReadShard {
  ShardHeader header;
  bool is_finished = false;
};
// Adds a shard to `io_work`, which belongs to the same level; after an error, `io_work` is unusable. Errors
// name the offset.
base::Result<ReadShard> read_shard(base::Bytes bytes, const std::vector<std::size_t>& luxels_of_map,
                                   LightWork& io_work);

}  // namespace temblor::compiler
