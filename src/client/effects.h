// What the client makes up by itself around what the server says: particles, trails, dynamic lights,
// lightning, marks. Behaves as the original did, but for what depended on its frame rate.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "client/client_state.h"
#include "client/seen_entity.h"
#include "render/scene.h"
#include "world/level.h"

namespace temblor::client {

struct EffectsSettings {
  std::size_t max_particles = 16384;  // r_particles_max; further ones are left out
  bool marks = false;                 // r_marks
};

enum class BeamModel : std::uint8_t { kBolt, kBolt2, kBolt3, kBeam };

// A piece of lightning: one model along its way.
struct BeamPiece {
  BeamModel model{};
  math::Vec3 origin_world{0.0f}, angles_deg{0.0f};
};

// What an effect needs to know of the moment.
struct Moment {
  const world::Level& level;
  double time_s;
  std::span<const SeenEntity> entities;
  std::span<const std::uint32_t> model_flags;  // formats::MdlFlags by precache number
  std::uint32_t view_entity;
};

class Effects {
 public:
  // The same seed and the same input give the same effects.
  explicit Effects(std::uint32_t seed = 1);
  ~Effects();

  void begin_level();
  // What happened, then what goes on, up to `moment`. Time must not run backwards; if it does (a demo
  // rewound), all that was under way ends.
  void advance(const Events& events, const Moment& moment, const EffectsSettings& settings);

  // Valid until the next advance().
  render::ParticleCloud particles() const;
  std::span<const render::DynamicLight> lights() const;
  std::span<const BeamPiece> beams() const;
  const render::MarkSet& marks() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace temblor::client
