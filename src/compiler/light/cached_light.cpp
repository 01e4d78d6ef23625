#include "compiler/light/cached_light.h"

#include <array>
#include <bit>
#include <map>

namespace temblor::compiler {
namespace {

// To the last bit: rays are to run the same way.
using PlaceBits = std::array<std::uint32_t, 3>;
PlaceBits bits_of_place(const math::Vec3& place) {
  return {std::bit_cast<std::uint32_t>(place.x), std::bit_cast<std::uint32_t>(place.y),
          std::bit_cast<std::uint32_t>(place.z)};
}

}  // namespace

CachedLight::CachedLight(const LightCache& cache, const LightCache& asked,
                         std::span<const LightSource> lights)
    : cache_(cache),
      holds_(cache.geometry != 0 && cache.geometry == asked.geometry),
      holds_dirt_(holds_ && cache.dirt == asked.dirt),
      holds_sky_(holds_dirt_ && cache.sky == asked.sky),
      number_of_light_(lights.size(), kUnknown) {
  if (!holds_) return;
  // Of several lights in one place the first is the first one again.
  std::map<PlaceBits, std::vector<std::uint32_t>> numbers;
  for (std::size_t i = cache.lights.size(); i-- > 0;)
    numbers[bits_of_place(cache.lights[i])].push_back(static_cast<std::uint32_t>(i));
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const auto found = numbers.find(bits_of_place(lights[i].origin_world));
    if (found == numbers.end() || found->second.empty()) continue;
    number_of_light_[i] = found->second.back();
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
