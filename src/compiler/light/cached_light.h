// The part of a light cache that is still valid for the level and its lights.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "compiler/light/light_cache.h"
#include "compiler/light/sources/light_source.h"

namespace temblor::compiler {

// Compares a cache with the present level once, then answers questions from any thread.
class CachedLight {
 public:
  // `asked`: a cache with only the hashes of the present level and light settings. `cache` outlives this.
  CachedLight(const LightCache& cache, const LightCache& asked, std::span<const LightSource> lights);

  // The cached data of a light map, or null. Its dirt and sky are valid only if holds_dirt() and
  // holds_sky().
  const LightCache::Map* map(std::size_t number) const;
  bool holds_dirt() const { return holds_dirt_; }
  bool holds_sky() const { return holds_sky_; }
  // BounceRays::seen of the cached level; empty: unknown.
  std::span<const std::uint32_t> bounces() const;
  // The number by which cached shadow records know a light; kUnknown if no light was in its place.
  static constexpr std::uint32_t kUnknown = std::numeric_limits<std::uint32_t>::max();
  std::uint32_t cached_number(std::size_t light) const { return cached_number_[light]; }

 private:
  const LightCache& cache_;
  bool holds_ = false, holds_dirt_ = false, holds_sky_ = false;
  std::vector<std::uint32_t> cached_number_;
};

}  // namespace temblor::compiler
