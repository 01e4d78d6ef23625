#include "client/debris/puffs.h"

#include <algorithm>
#include <cmath>

namespace temblor::client {

namespace {

Puff place_puff(const PuffSpawn& puff, double age_s) {
  constexpr double kDrag = 4;  // per second
  const auto age = static_cast<float>(age_s / puff.life_s);
  const auto drifted_s = static_cast<float>((1 - std::exp(-kDrag * age_s)) / kDrag);
  Puff shown{.picture = puff.picture, .angles_deg = puff.angles_deg, .age = age};
  shown.origin_world = puff.origin_world + puff.velocity * drifted_s;
  shown.origin_world.z += puff.rise * static_cast<float>(age_s);
  shown.scale = std::lerp(puff.first_scale, puff.last_scale, std::sqrt(age));
  shown.alpha = puff.opacity * (1 - age);
  return shown;
}

}  // namespace

void Puffs::add(const PuffSpawn& puff) {
  if (size_ < kMaxPuffs) {
    spawned_[size_++] = puff;
    return;
  }
  const auto ends_first = [](const PuffSpawn& a, const PuffSpawn& b) {
    return a.born_s + a.life_s < b.born_s + b.life_s;
  };
  *std::min_element(spawned_.begin(), spawned_.end(), ends_first) = puff;
}

void Puffs::advance(double time_s) {
  std::size_t kept = 0;
  shown_count_ = 0;
  for (std::size_t i = 0; i < size_; ++i) {
    const double age_s = time_s - spawned_[i].born_s;
    if (age_s >= spawned_[i].life_s) continue;
    spawned_[kept++] = spawned_[i];
    if (age_s >= 0) shown_[shown_count_++] = place_puff(spawned_[i], age_s);
  }
  size_ = kept;
}

}  // namespace temblor::client
