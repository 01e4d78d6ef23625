// The light of some of a level's light maps, saved by one of several processes that share the work.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/bytes.h"
#include "base/result.h"
#include "compiler/light/face_light.h"

namespace temblor::compiler {

struct ShardHeader {
  std::uint64_t level = 0;  // a hash of the level and all that it is lit by
  std::uint32_t index = 0, count = 1;
  bool operator==(const ShardHeader&) const = default;
};

// Light maps index, index + count, ... of `light`, which is by map (LitLevel::maps).
base::ByteVector write_shard(const ShardHeader& header, const std::vector<FaceLight>& light);

struct Shard {
  ShardHeader header;
  std::vector<std::pair<std::uint32_t, FaceLight>> maps;
};

// Every map's layers have as many samples as `luxels_of_map` says. Errors name the offset.
base::Result<Shard> read_shard(base::Bytes bytes, const std::vector<std::size_t>& luxels_of_map);

}  // namespace temblor::compiler
