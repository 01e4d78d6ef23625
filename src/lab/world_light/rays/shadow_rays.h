// Lines between points of a level and its lights, followed by Embree. Only the world's own faces block them,
// except sky, liquids, and fences.
#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "base/result.h"
#include "world/level.h"

namespace temblor::lab {

constexpr std::size_t kRaysPerPacket = 16;

// Points in world space, by axis.
using PointPacket = std::array<std::array<float, kRaysPerPacket>, 3>;

// Never changes; any number of threads may query it.
class ShadowRays {
 public:
  // Fails with kUnsupported if Embree is missing or does not run, and with kTooLarge if memory runs out.
  static base::Result<ShadowRays> make(const world::Level& level);
  // Fails with kUnsupported where make() would.
  static base::Status check();
  ~ShadowRays();
  ShadowRays(ShadowRays&&) noexcept;
  ShadowRays& operator=(ShadowRays&&) noexcept;

  // Bit i: nothing is between point i and the lamp. Only points whose bit is in `wanted` are looked at.
  std::uint32_t find_lit(const PointPacket& points, std::uint32_t wanted, const math::Vec3& lamp_world) const;
  // The same for light from far away: bit i says that the first face from point i along `toward_sky`, of
  // length 1, is sky.
  std::uint32_t find_under_sky(const PointPacket& points, std::uint32_t wanted,
                               const math::Vec3& toward_sky) const;

 private:
  struct Scene;
  explicit ShadowRays(std::unique_ptr<Scene> scene);
  std::unique_ptr<Scene> scene_;
};

}  // namespace temblor::lab
