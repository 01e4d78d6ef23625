// What the client makes up by itself around what the server says: particles, trails, dynamic lights,
// lightning, marks. Behaves as the original did, but for what depended on its frame rate: what there is at a
// time does not depend on how often it was asked for before.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "client/effects/beams.h"
#include "client/session/client_state.h"
#include "client/session/seen_entity.h"
#include "render/scene.h"
#include "world/level.h"

namespace temblor::client {

struct EffectsSettings {
  std::size_t max_particles = 16384;  // r_particles_max; further ones are left out
  bool marks = false;                 // r_marks; turned off, the marks that there are go
};

// What an effect needs to know of the moment.
struct Moment {
  const world::Level& level;
  double time_s;
  std::span<const SeenEntity> entities;
  std::span<const std::uint32_t> model_flags;  // formats::MdlFlags by precache number; missing ones: none
  std::uint32_t view_entity;
  // Where the view entity is shown, if that is not where it is told to be: its lights and beams go with it.
  std::optional<math::Vec3> own_origin_world{};
};

// The yaw of models that turn by themselves (formats::kMdlRotate), 0 to 360.
float rotated_yaw_deg(double time_s);

// How much has happened that has a chance of its own.
struct EffectCounts {
  std::uint32_t events = 0, hits = 0;
};

class Effects {
 public:
  // The same seed and the same input give the same effects.
  explicit Effects(std::uint32_t seed = 1);
  ~Effects();

  void begin_level();
  // The same, and chance is what it would be after that much has happened: for a recording that is sought in.
  void resume(const EffectCounts& before);
  static void count(const Events& events, EffectCounts& io_counts);
  // What happened, then what goes on, up to `moment`. Time must not run backwards; if it does (a demo
  // rewound), all that was under way ends. When it stands still, nothing goes on. Once warm it asks the heap
  // for nothing, but for the first mark on a face.
  void advance(const Events& events, const Moment& moment, const EffectsSettings& settings);

  // Valid until the next advance().
  render::ParticleCloud particles() const;
  std::size_t particles_left_out() const;  // of this level, for want of room
  std::span<const render::DynamicLight> lights() const;
  std::span<const BeamPiece> beams() const;
  const render::MarkSet& marks() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace temblor::client
