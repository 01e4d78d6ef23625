// Dynamic lights: each shines for a time and may shrink. An entity has one at most.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "math/vec.h"
#include "render/scene.h"

namespace temblor::client {

struct LightBirth {
  std::uint32_t entity = 0;  // whose; its older light goes out. 0: nobody's
  math::Vec3 origin_world{0.0f};
  float radius = 0;               // units, when it is born
  float least = 0;                // as render::DynamicLight
  float shrinks_per_second = 0;   // units
  double born_s = 0, life_s = 0;  // life 0: for one moment
};

// 0 to 31 units by which an entity's light is larger than its least: changes ten times a second of the
// server's time, whatever the frame rate.
float light_flicker(std::uint32_t entity, double time_s);

class DynamicLights {
 public:
  // Four times the original's. When all shine, the one that ends first goes out for a new one.
  static constexpr std::size_t kMost = 128;

  void clear() { size_ = 0; }
  void add(const LightBirth& birth);
  // Puts out those whose time is over, and works out the others' radius at `time_s`.
  void advance(double time_s);
  // As of the last advance(). Valid until anything changes.
  std::span<const render::DynamicLight> lights() const { return {shining_.data(), size_}; }

 private:
  std::size_t slot_for(std::uint32_t entity) const;

  std::size_t size_ = 0;
  std::array<LightBirth, kMost> births_;
  std::array<render::DynamicLight, kMost> shining_;
};

}  // namespace temblor::client
