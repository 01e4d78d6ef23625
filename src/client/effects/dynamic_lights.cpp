#include "client/effects/dynamic_lights.h"

#include <algorithm>
#include <cmath>

#include "base/hash.h"

namespace temblor::client {

namespace {

double end_s(const TimedLight& light) {
  return light.born_s + light.life_s;
}

render::DynamicLight sample_light(const TimedLight& light, double time_s) {
  const double age_s = std::max(0.0, time_s - light.born_s);
  const double radius = double{light.radius} - double{light.shrinks_per_second} * age_s;
  return {light.origin_world, static_cast<float>(std::max(0.0, radius)), light.min_light, light.color};
}

}  // namespace

float light_flicker(std::uint32_t entity, double time_s) {
  // Counts tenths of a second in a signed integer, as times before 0 are valid too.
  const auto step = static_cast<std::int64_t>(std::floor(time_s * 10));
  return static_cast<float>(base::hash_with(entity, static_cast<std::uint64_t>(step)) & 31);
}

void DynamicLights::add(const TimedLight& light) {
  const std::size_t slot = find_slot(light.entity);
  timed_lights_[slot] = light;
  shining_[slot] = sample_light(light, light.born_s);
  size_ = std::max(size_, slot + 1);
}

// Returns the entity's own slot, a free one, or that of the light that ends first.
std::size_t DynamicLights::find_slot(std::uint32_t entity) const {
  if (entity != 0)
    for (std::size_t i = 0; i < size_; ++i)
      if (timed_lights_[i].entity == entity) return i;
  if (size_ < kMaxLights) return size_;
  const auto soonest =
      std::min_element(timed_lights_.begin(), timed_lights_.end(),
                       [](const TimedLight& a, const TimedLight& b) { return end_s(a) < end_s(b); });
  return static_cast<std::size_t>(soonest - timed_lights_.begin());
}

// Closes gaps in place, so lights keep their order. A light whose radius has shrunk to 0 ends early.
void DynamicLights::advance(double time_s) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < size_; ++i) {
    if (end_s(timed_lights_[i]) < time_s) continue;
    timed_lights_[kept] = timed_lights_[i];
    shining_[kept] = sample_light(timed_lights_[kept], time_s);
    if (shining_[kept].radius > 0) ++kept;
  }
  size_ = kept;
}

}  // namespace temblor::client
