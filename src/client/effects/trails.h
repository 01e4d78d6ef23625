// Trails: particles along the path of rockets, grenades, gibs and spikes.
//
// A trail has one particle per 3 units of path (6 for the thin trail of zombie parts), however frames divide
// the path into pieces: the remainder of a piece carries over to the next. Each particle is as old as the
// time since its place was passed. Each trail has its own random numbers, seeded by the entity and the place
// it started at, and by nothing before.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "client/effects/effect_random.h"
#include "client/effects/particles.h"

namespace temblor::client {

// The original's kinds of trail, by model flag.
enum class TrailKind : std::uint8_t {
  kRocket,
  kGrenade,
  kBlood,
  kThinBlood,  // zombie parts
  kTracer,     // green: scrags
  kTracer2,    // yellow: knights
  kVoor        // purple: vores
};

// Returns the trail of a model with these formats::MdlFlags; nothing if it has none. If several flags are
// set, the first of blood, thin blood, tracers, rocket, grenade and vore counts.
std::optional<TrailKind> find_trail_kind(std::uint32_t model_flags);

// A straight piece of an entity's path, from one frame to the next.
struct TrailPiece {
  std::uint32_t entity = 0;  // below InterpolatedEntity::kFirstStatic
  TrailKind kind{};
  math::Vec3 from_world{0.0f}, to_world{0.0f};
  double from_time_s = 0, to_time_s = 0;
};

class Trails {
 public:
  // The same seed and paths give the same particles.
  explicit Trails(std::uint32_t seed) : seed_(seed) {}

  void clear();
  // The entity has appeared at this place: a new trail begins.
  void begin(std::uint32_t entity, const math::Vec3& origin_world);
  // Adds the particles along a piece of path.
  void emit(const TrailPiece& piece, ParticlePool& io_pool);

 private:
  struct Emitter {
    EffectRandom random;
    // Units of path until the next particle.
    double until_next = 0;
    std::uint32_t count = 0;  // emitted so far
  };
  Emitter& get_emitter(std::uint32_t entity);

  std::uint32_t seed_;
  std::vector<Emitter> emitters_;  // by entity
};

}  // namespace temblor::client
