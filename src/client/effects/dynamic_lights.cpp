#include "client/effects/dynamic_lights.h"

#include <algorithm>
#include <cmath>

#include "base/hash.h"

namespace temblor::client {

namespace {

double end_s(const LightBirth& birth) {
  return birth.born_s + birth.life_s;
}

render::DynamicLight light_at(const LightBirth& birth, double time_s) {
  const double age_s = std::max(0.0, time_s - birth.born_s);
  const double radius = double{birth.radius} - double{birth.shrinks_per_second} * age_s;
  return {birth.origin_world, static_cast<float>(std::max(0.0, radius)), birth.least};
}

}  // namespace

float light_flicker(std::uint32_t entity, double time_s) {
  // Whole steps as a signed number, whose bits are the same however it is told.
  const auto step = static_cast<std::int64_t>(std::floor(time_s * 10));
  return static_cast<float>(base::hash_with(entity, static_cast<std::uint64_t>(step)) & 31);
}

void DynamicLights::add(const LightBirth& birth) {
  const std::size_t slot = slot_for(birth.entity);
  births_[slot] = birth;
  shining_[slot] = light_at(birth, birth.born_s);
  size_ = std::max(size_, slot + 1);
}

std::size_t DynamicLights::slot_for(std::uint32_t entity) const {
  if (entity != 0)
    for (std::size_t i = 0; i < size_; ++i)
      if (births_[i].entity == entity) return i;
  if (size_ < kMost) return size_;
  const auto soonest =
      std::min_element(births_.begin(), births_.end(),
                       [](const LightBirth& a, const LightBirth& b) { return end_s(a) < end_s(b); });
  return static_cast<std::size_t>(soonest - births_.begin());
}

void DynamicLights::advance(double time_s) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < size_; ++i) {
    if (end_s(births_[i]) < time_s) continue;
    births_[kept] = births_[i];
    shining_[kept] = light_at(births_[kept], time_s);
    if (shining_[kept].radius > 0) ++kept;
  }
  size_ = kept;
}

}  // namespace temblor::client
