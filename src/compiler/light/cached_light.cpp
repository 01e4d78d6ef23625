// Lights are matched by their origins. The cache knows shadows, which depend only on the origin, so a light
// keeps its cached shadows when its brightness, color, angle or formula changes.
#include "compiler/light/cached_light.h"

#include <array>
#include <bit>
#include <map>

namespace temblor::compiler {
namespace {

// Compared bit by bit, since only equal origins have the same rays.
using PlaceBits = std::array<std::uint32_t, 3>;
PlaceBits make_place_bits(const math::Vec3& place) {
  return {std::bit_cast<std::uint32_t>(place.x), std::bit_cast<std::uint32_t>(place.y),
          std::bit_cast<std::uint32_t>(place.z)};
}

}  // namespace

// Dirt depends on the geometry, and the sky's light also on dirt, so each needs the one before.
CachedLight::CachedLight(const LightCache& cache, const LightCache& asked,
                         std::span<const LightSource> lights)
    : cache_(cache),
      holds_(cache.geometry != 0 && cache.geometry == asked.geometry),
      holds_dirt_(holds_ && cache.dirt == asked.dirt),
      holds_sky_(holds_dirt_ && cache.sky == asked.sky),
      cached_number_(lights.size(), kUnknown) {
  if (!holds_) return;
  // If several lights share an origin, the first one in the cache stands for the first one now.
  std::map<PlaceBits, std::vector<std::uint32_t>> numbers;
  for (std::size_t i = cache.lights.size(); i-- > 0;)
    numbers[make_place_bits(cache.lights[i])].push_back(static_cast<std::uint32_t>(i));
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const auto found = numbers.find(make_place_bits(lights[i].origin_world));
    if (found == numbers.end() || found->second.empty()) continue;
    cached_number_[i] = found->second.back();
    found->second.pop_back();
  }
}

const LightCache::Map* CachedLight::map(std::size_t number) const {
  return holds_ && number < cache_.maps.size() ? &cache_.maps[number] : nullptr;
}

std::span<const std::uint32_t> CachedLight::bounces() const {
  return holds_ ? std::span<const std::uint32_t>(cache_.bounces) : std::span<const std::uint32_t>();
}

}  // namespace temblor::compiler
