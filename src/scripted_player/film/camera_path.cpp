#include "scripted_player/film/camera_path.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <span>

namespace temblor::player {
namespace {

// The followed player's place reaches a new one with this time constant.
constexpr double kFollow_s = 0.2;

// The curve through values at the keys' times. `value_at(i)` is that of key i.
template <typename ValueAt>
math::Vec3 interpolate(std::span<const CameraKey> keys, double time_s, const ValueAt& value_at) {
  const std::size_t last = keys.size() - 1;
  if (time_s <= keys.front().time_s) return value_at(0);
  if (time_s >= keys.back().time_s) return value_at(last);
  std::size_t i = 0;
  while (keys[i + 1].time_s < time_s) ++i;
  // Units per second; at both ends, that of the only neighbor.
  const auto slope = [&](std::size_t key) {
    const std::size_t before = key == 0 ? 0 : key - 1, after = std::min(key + 1, last);
    return (value_at(after) - value_at(before)) /
           static_cast<float>(keys[after].time_s - keys[before].time_s);
  };
  const auto span_s = static_cast<float>(keys[i + 1].time_s - keys[i].time_s);
  const float t = static_cast<float>(time_s - keys[i].time_s) / span_s;
  const float t2 = t * t, t3 = t2 * t;
  return (2 * t3 - 3 * t2 + 1) * value_at(i) + (t3 - 2 * t2 + t) * span_s * slope(i) +
         (3 * t2 - 2 * t3) * value_at(i + 1) + (t3 - t2) * span_s * slope(i + 1);
}

// Pitch (positive down) and yaw of a direction.
math::Vec3 find_angles_deg(const math::Vec3& direction) {
  return {glm::degrees(-std::atan2(direction.z, std::hypot(direction.x, direction.y))),
          glm::degrees(std::atan2(direction.y, direction.x)), 0.0f};
}

}  // namespace

CameraPose CameraPath::advance(double time_s, const math::Vec3& player_world) {
  if (followed_world_) {
    const double share = 1 - std::exp((last_time_s_ - time_s) / kFollow_s);
    *followed_world_ += (player_world - *followed_world_) * static_cast<float>(share);
  } else {
    followed_world_ = player_world;
  }
  last_time_s_ = time_s;
  const std::span<const CameraKey> keys = shot_.camera;
  const math::Vec3 place = interpolate(keys, time_s, [&](std::size_t i) {
    return keys[i].is_relative ? *followed_world_ + keys[i].place : keys[i].place;
  });
  const math::Vec3 target = interpolate(
      keys, time_s, [&](std::size_t i) { return keys[i].target_world.value_or(*followed_world_); });
  return {place, find_angles_deg(target - place)};
}

}  // namespace temblor::player
