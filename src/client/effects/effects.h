// Effects that the client adds to what the server sends: particles, trails, dynamic lights, lightning, bullet
// marks, casings, and smoke.
//
//   temporary entities, svc_particle --> bursts, flashes, beams, marks --+--> render::Scene
//   entities: model flags, effects ----> trails, glow, flashes, casings -+
//
// They look like the original's, except where those depended on the frame rate: the effects at a given time
// do not depend on how often they were advanced before. All randomness comes from counters and seeds, so a
// demo looks the same each time and after each seek.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "client/debris/casings.h"
#include "client/debris/puffs.h"
#include "client/debris/shots.h"
#include "client/effects/beams.h"
#include "client/effects/mark_pictures.h"
#include "client/session/client_state.h"
#include "client/session/interpolated_entity.h"
#include "render/scene.h"
#include "world/level.h"
#include "world/visibility.h"

namespace temblor::client {

struct EffectsSettings {
  std::size_t max_particles = 16384;  // r_particles_max; further particles are dropped
  bool marks = false;                 // r_marks: marks of shots; turning it off removes them
  bool muzzle_flashes = true;         // shots light up the level
  bool colored_lights = false;        // r_dynamic_colors: see light_colors.h; lightning lights what it hits
  bool casings = false;               // cl_casings: guns throw out empty casings
  bool smoke = false;                 // cl_smoke: barrels and blasts smoke
  bool impacts = false;               // cl_impacts: hits look like the wall's material
  bool barrel_beams = false;          // cl_barrelbeam: the viewer's lightning starts at the drawn gun
  bool splashes = false;              // cl_splashes: liquids splash
};

// The state of the game at the time of an advance(). References must be valid during the call.
struct EffectsInput {
  const world::Level& level;
  // On the server's clock.
  double time_s;
  std::span<const InterpolatedEntity> entities;
  std::span<const std::uint32_t> model_flags;  // formats::MdlFlags by precache number; 0 past the end
  // The entity whose eyes the player sees through.
  std::uint32_t view_entity;
  // The predicted place of the view entity, where its lights and beams are; nothing without prediction.
  std::optional<math::Vec3> predicted_origin_world{};
  // By precache number: the level's own brush models, which can carry marks; the world (0) for other models.
  // Marks belong to faces, so models that several entities share, such as boxes of shells, get none.
  std::span<const world::ModelIndex> submodels{};
  // For the marks that the game asks for; null: none.
  const MarkPictures* mark_pictures = nullptr;
  // By precache number; a missing name is that of no gun.
  std::span<const std::string> model_names{};
  // By precache number: heights of alias models, units; bodies make larger splashes than nails.
  std::span<const float> model_heights{};
  // The view entity's gun; nothing if the picture does not show it in the hand.
  std::optional<HeldGun> held_gun{};
  // The func_water of a Half-Life level, where they are now: things splash into them.
  std::span<const world::PlacedLiquid> liquids{};
};

// The yaw of models that rotate on the spot, such as items (formats::kMdlRotate), in [0, 360): 100 degrees a
// second.
float compute_rotated_yaw_deg(double time_s);

// How many events and hits there have been. The counters seed the random numbers of each event; a seek in a
// demo restores them.
struct EffectCounts {
  std::uint32_t events = 0, hits = 0;
};

class Effects {
 public:
  // The same seed and input give the same effects.
  explicit Effects(std::uint32_t seed = 1);
  ~Effects();

  // Removes all effects.
  void begin_level();
  // Like begin_level(), and continues with the random numbers that follow after `before`. For seeking in
  // demos.
  void resume(const EffectCounts& before);
  // Adds the events that advance() would count, without their effects.
  static void count(const Events& events, EffectCounts& io_counts);
  // Starts effects for `events` and continues the others up to `input`. If time runs backward (a demo was
  // rewound), all effects end; if it stands still, nothing continues. In the steady state it allocates
  // nothing, except for the first mark on a face.
  void advance(const Events& events, const EffectsInput& input, const EffectsSettings& settings);

  // Results; valid until the next advance().
  render::ParticleCloud particles() const;
  std::size_t dropped_particles() const;  // of this level, beyond max_particles
  std::span<const render::DynamicLight> lights() const;
  std::span<const BeamPiece> beams() const;
  const render::MarkSet& marks() const;
  std::span<const CasingPiece> casings() const;
  std::span<const Puff> puffs() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace temblor::client
