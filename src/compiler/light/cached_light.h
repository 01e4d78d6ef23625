// What of a cache holds for the level and the lights at hand.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "compiler/light/light_cache.h"
#include "compiler/light/sources/light_source.h"

namespace temblor::compiler {

class CachedLight {
 public:
  // `asked`: a cache with the hashes of what is to be lit, otherwise empty. `cache`: outlives this.
  CachedLight(const LightCache& cache, const LightCache& asked, std::span<const LightSource> lights);

  // Of a light map; null: nothing is known. Whether its dirt and sky hold is asked of these.
  const LightCache::Map* map(std::size_t number) const;
  bool holds_dirt() const { return holds_dirt_; }
  bool holds_sky() const { return holds_sky_; }
  std::span<const std::uint32_t> bounces() const;
  // By which number records of shadows name a light; kUnknown where none stood in its place.
  static constexpr std::uint32_t kUnknown = std::numeric_limits<std::uint32_t>::max();
  std::uint32_t number_of(std::size_t light) const { return number_of_light_[light]; }

 private:
  const LightCache& cache_;
  bool holds_ = false, holds_dirt_ = false, holds_sky_ = false;
  std::vector<std::uint32_t> number_of_light_;
};

}  // namespace temblor::compiler
