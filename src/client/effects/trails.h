// Trails: particles left along the way of rockets, grenades, gibs and spikes.
//
// One for every so many units of way, whatever pieces the way comes in: what is left of a piece is carried
// over to the next. Each is as old as the time since its place was passed. Every trail has a chance of its
// own, by which entity leaves it and where that came from, and by nothing that was before.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "client/effects/effect_random.h"
#include "client/effects/particles.h"

namespace temblor::client {

enum class TrailKind : std::uint8_t {
  kRocket,
  kGrenade,
  kBlood,
  kThinBlood,  // of zombies' parts
  kTracer,     // green: of scrags
  kTracer2,    // yellow: of knights
  kVoor        // purple: of vores
};

// What a model with those formats::MdlFlags leaves behind: one kind at most.
std::optional<TrailKind> trail_kind(std::uint32_t model_flags);

// A straight piece of an entity's way.
struct TrailPiece {
  std::uint32_t entity = 0;  // below SeenEntity::kFirstStatic
  TrailKind kind{};
  math::Vec3 from_world{0.0f}, to_world{0.0f};
  double from_time_s = 0, to_time_s = 0;
};

class Trails {
 public:
  // The same seed and the same ways give the same particles.
  explicit Trails(std::uint32_t seed) : seed_(seed) {}

  void clear();
  // The entity has come there out of nowhere: what it leaves from there on is another trail.
  void begin(std::uint32_t entity, const math::Vec3& origin_world);
  void leave(const TrailPiece& piece, ParticlePool& io_pool);

 private:
  struct Carried {
    EffectRandom random;
    double until_next = 0;    // units of way
    std::uint32_t count = 0;  // left so far
  };
  Carried& carried(std::uint32_t entity);

  std::uint32_t seed_;
  std::vector<Carried> carried_;  // by entity
};

}  // namespace temblor::client
