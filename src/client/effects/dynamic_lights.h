// Dynamic lights with a lifetime and optional shrinking: explosions, muzzle flashes, glowing entities.
//
// Like the original's they are spheres of light that the renderer adds to light maps and models. Radius and
// end are computed from the age, so the light at a given time does not depend on the frame rate. An entity
// has at most one light.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "math/vec.h"
#include "render/scene.h"

namespace temblor::client {

// A light at the time at which it is added.
struct TimedLight {
  // The owner, whose older light ends; 0: none.
  std::uint32_t entity = 0;
  math::Vec3 origin_world{0.0f};
  // Units, when the light is added.
  float radius = 0;
  // See render::DynamicLight.
  float min_light = 0;
  // Units per second.
  float shrinks_per_second = 0;
  // A life of 0 lasts for one frame.
  double born_s = 0, life_s = 0;
  // See render::DynamicLight.
  math::Vec3 color{1.0f};
};

// The flicker of an entity's light: 0 to 31 units added to its radius. Changes ten times a second of server
// time at any frame rate.
float light_flicker(std::uint32_t entity, double time_s);

class DynamicLights {
 public:
  // Four times the original's number. If all are in use, a new light replaces the one that ends first.
  static constexpr std::size_t kMaxLights = 128;

  void clear() { size_ = 0; }
  // Adds a light. It shines from the next lights() on.
  void add(const TimedLight& light);
  // Removes expired lights and computes the radius of the others at `time_s`.
  void advance(double time_s);
  // The lights as of the last advance(). Valid until anything changes.
  std::span<const render::DynamicLight> lights() const { return {shining_.data(), size_}; }

 private:
  std::size_t find_slot(std::uint32_t entity) const;

  std::size_t size_ = 0;
  std::array<TimedLight, kMaxLights> timed_lights_;
  std::array<render::DynamicLight, kMaxLights> shining_;
};

}  // namespace temblor::client
