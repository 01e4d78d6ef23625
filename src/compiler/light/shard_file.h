// What one of several processes that share the work has found out of a level's light, saved: to be joined, or
// to go on from.
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

struct ShardHeader {
  std::uint64_t level = 0;  // a hash of the level and all that it is lit by
  std::uint32_t index = 0, count = 1;
  bool operator==(const ShardHeader&) const = default;
};

// How far a level's light is: what comes straight from lights, and the rays of what bounces.
struct LightWork {
  std::vector<FaceLight> light;      // by light map (LitLevel::maps)
  std::vector<std::uint8_t> is_lit;  // by light map, 0 or 1
  BounceRays bounces;                // of no face where no light bounces
};
LightWork begin_light(const LitLevel& lit, bool bounces);

// Of `total` maps or faces those that are a shard's: index, index + count, ...
std::vector<std::uint32_t> share_of(const ShardHeader& shard, std::size_t total);

// What is done of the shard's light maps and faces. The same bytes however often the work was stopped.
base::ByteVector write_shard(const ShardHeader& header, const LightWork& work);

struct ReadShard {
  ShardHeader header;
  bool is_finished = false;
};
// Adds a shard to `io_work`, which is of the level at hand; after an error that is in no certain state.
// Errors name the offset.
base::Result<ReadShard> read_shard(base::Bytes bytes, const std::vector<std::size_t>& luxels_of_map,
                                   LightWork& io_work);

}  // namespace temblor::compiler
