// Splashes where something crosses the surface of a liquid: drops, rings on the surface, and bubbles below.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "client/debris/puffs.h"
#include "client/effects/particle_bursts.h"
#include "world/level.h"
#include "world/visibility.h"

namespace temblor::client {

// Whether something can splash into it: water, slime, lava, and currents.
bool is_liquid_contents(world::Contents contents);

// Where a straight path meets the surface of a liquid.
struct Crossing {
  math::Vec3 surface_world{0.0f};
  world::Contents liquid{};
  bool enters = false;
};
// Returns nothing if the two ends are both in a liquid, or neither is. Within 1/16 of a unit. `liquids` says
// where the func_water of a Half-Life level are now (world::point_contents).
std::optional<Crossing> find_crossing(const world::Level& level, const math::Vec3& from, const math::Vec3& to,
                                      std::span<const world::PlacedLiquid> liquids = {});

// `size`: 1 is a player that falls in, 0.3 a nail.
void spawn_splash(const BurstContext& context, const Crossing& crossing, float size, Puffs& io_puffs);

// Bubbles along a path below a surface, which rise to it.
void spawn_bubbles(const BurstContext& context, const math::Vec3& surface_world, const math::Vec3& end_world,
                   int count, Puffs& io_puffs);

// Remembers who has just splashed: a swimmer who bobs at the surface makes no new splash each time.
class SplashTimes {
 public:
  static constexpr double kPause_s = 0.35;
  void clear() { last_s_.clear(); }
  // Returns whether the entity (below InterpolatedEntity::kFirstStatic) may splash now, and notes that it
  // does.
  bool begin(std::uint32_t entity, double time_s);

 private:
  std::vector<double> last_s_;  // by entity
};

}  // namespace temblor::client
