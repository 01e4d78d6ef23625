#include "client/effects/effects.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/hash.h"
#include "client/effects/dynamic_lights.h"
#include "client/effects/effect_random.h"
#include "client/effects/hit_marks.h"
#include "client/effects/particle_bursts.h"
#include "client/effects/particles.h"
#include "client/effects/trails.h"
#include "formats/models/mdl.h"
#include "math/angles.h"

namespace temblor::client {

namespace {

using net::TempEntity;
using net::TempEntityKind;

constexpr std::uint16_t kCountOfExplosion = 1024;

std::optional<BeamModel> beam_model(TempEntityKind kind) {
  switch (kind) {
    case TempEntityKind::kLightning1:
      return BeamModel::kBolt;
    case TempEntityKind::kLightning2:
      return BeamModel::kBolt2;
    case TempEntityKind::kLightning3:
      return BeamModel::kBolt3;
    case TempEntityKind::kBeam:
      return BeamModel::kBeam;
    default:
      return std::nullopt;
  }
}

// Chips of stone or sparks, in the colors that the original gave them.
struct Chips {
  std::uint8_t color;
  std::size_t count;
};
std::optional<Chips> chips_of(TempEntityKind kind) {
  switch (kind) {
    case TempEntityKind::kSpike:
      return Chips{0, 10};
    case TempEntityKind::kSuperSpike:
    case TempEntityKind::kGunshot:
      return Chips{0, 20};
    case TempEntityKind::kWizSpike:
      return Chips{20, 30};
    case TempEntityKind::kKnightSpike:
      return Chips{226, 20};
    default:
      return std::nullopt;
  }
}

// How a hit marks the wall: shots end up to 4 units before it, rockets 8.
std::optional<Hit> hit_of(const TempEntity& what) {
  switch (what.kind) {
    case TempEntityKind::kGunshot:
    case TempEntityKind::kSpike:
    case TempEntityKind::kWizSpike:
      return Hit{render::MarkKind::kBulletHole, what.origin, 6, 4};
    case TempEntityKind::kSuperSpike:
    case TempEntityKind::kKnightSpike:
      return Hit{render::MarkKind::kBulletHole, what.origin, 6, 5};
    case TempEntityKind::kExplosion:
    case TempEntityKind::kTarExplosion:
    case TempEntityKind::kExplosion2:
      return Hit{render::MarkKind::kScorch, what.origin, 28, 32};
    default:
      return std::nullopt;
  }
}

// Blood is a burst in the palette's row of reds. More of it leaves a larger splatter.
std::optional<Hit> hit_of(const net::Particles& burst) {
  constexpr std::uint8_t kReds = 64 / 16;
  if (burst.color / 16 != kReds || burst.count == kCountOfExplosion) return std::nullopt;
  const float radius = std::min(4.0f + static_cast<float>(burst.count) / 8, 16.0f);
  return Hit{render::MarkKind::kSplatter, burst.origin, 48, radius};
}

}  // namespace

float rotated_yaw_deg(double time_s) {
  constexpr double kDegreesPerSecond = 100;
  const double yaw_deg = std::fmod(time_s * kDegreesPerSecond, 360.0);
  return static_cast<float>(yaw_deg < 0 ? yaw_deg + 360 : yaw_deg);
}

struct Effects::State {
  explicit State(std::uint32_t seed_of_all) : seed(seed_of_all), trails(seed_of_all) {}

  void clear();
  void happen(const Events& events, const Moment& moment, bool leave_marks);
  EffectRandom next_chance() { return EffectRandom(base::hash_with(seed, ++count.events)); }
  void begin(const TempEntity& what, const Moment& moment);
  void begin(const net::Particles& what, const Moment& moment);
  void mark(std::optional<Hit> hit, const Moment& moment);
  void go_on(const Moment& moment);
  void leave_trail(const SeenEntity& entity, TrailKind kind, double time_s);
  void shine(const SeenEntity& entity, const math::Vec3& origin_world, bool rocket, double time_s);
  std::optional<Beams::Held> held_beam(const Moment& moment) const;

  std::uint32_t seed;
  // Each event has a chance of its own, which does not depend on what moments were looked at before it.
  // Marks' is another: with them or without, particles fly alike.
  EffectCounts count;
  ParticlePool particles;
  Trails trails;
  DynamicLights lights;
  Beams beams;
  HitMarks hit_marks;
  render::MarkSet marks;
  std::optional<double> last_time_s;
};

void Effects::State::clear() {
  particles.clear();
  trails.clear();
  lights.clear();
  beams.clear();
  marks.clear();
  last_time_s.reset();
}

void Effects::State::happen(const Events& events, const Moment& moment, bool leave_marks) {
  for (const TempEntity& what : events.temp_entities) {
    begin(what, moment);
    if (leave_marks) mark(hit_of(what), moment);
  }
  for (const net::Particles& what : events.particles) {
    begin(what, moment);
    if (leave_marks) mark(hit_of(what), moment);
  }
}

void Effects::State::begin(const net::Particles& what, const Moment& moment) {
  EffectRandom random = next_chance();
  const BurstContext burst{particles, random, moment.time_s};
  if (what.count == kCountOfExplosion)
    burst_explosion(burst, what.origin);
  else
    burst_chips(burst, what.origin, what.direction, what.color, what.count);
}

void Effects::State::begin(const TempEntity& what, const Moment& moment) {
  EffectRandom random = next_chance();
  const BurstContext burst{particles, random, moment.time_s};
  const LightBirth flash{.origin_world = what.origin,
                         .radius = 350,
                         .shrinks_per_second = 300,
                         .born_s = moment.time_s,
                         .life_s = 0.5};
  if (const std::optional<Chips> chips = chips_of(what.kind))
    burst_chips(burst, what.origin, math::Vec3(0.0f), chips->color, chips->count);
  if (const std::optional<BeamModel> model = beam_model(what.kind))
    beams.add({what.entity, *model, what.origin, what.end, moment.time_s});
  switch (what.kind) {
    case TempEntityKind::kExplosion:
      burst_explosion(burst, what.origin);
      lights.add(flash);
      break;
    case TempEntityKind::kExplosion2:
      burst_colored_explosion(burst, what.origin, what.color_start, what.color_count);
      lights.add(flash);
      break;
    case TempEntityKind::kTarExplosion:
      burst_blob_explosion(burst, what.origin);
      break;
    case TempEntityKind::kLavaSplash:
      burst_lava_splash(burst, what.origin);
      break;
    case TempEntityKind::kTeleport:
      burst_teleport(burst, what.origin);
      break;
    default:
      break;
  }
}

void Effects::State::mark(std::optional<Hit> hit, const Moment& moment) {
  if (!hit) return;
  hit->seed = static_cast<std::uint32_t>(base::mixed_bits(++count.hits));
  hit_marks.leave(moment.level, *hit, marks);
}

void Effects::State::go_on(const Moment& moment) {
  for (const SeenEntity& entity : moment.entities) {
    if (entity.number >= SeenEntity::kFirstStatic) break;
    const std::uint32_t flags =
        entity.model < moment.model_flags.size() ? moment.model_flags[entity.model] : 0;
    const std::optional<TrailKind> trail = trail_kind(flags);
    if (trail && entity.has_come) trails.begin(entity.number, entity.origin_world);
    if (trail) leave_trail(entity, *trail, moment.time_s);
    const math::Vec3 place_world = entity.number == moment.view_entity && moment.own_origin_world
                                       ? *moment.own_origin_world
                                       : entity.origin_world;
    if (entity.effects & kEffectBrightField) show_bright_field(particles, moment.time_s, place_world);
    shine(entity, place_world, trail == TrailKind::kRocket, moment.time_s);
  }
}

void Effects::State::leave_trail(const SeenEntity& entity, TrailKind kind, double time_s) {
  trails.leave({entity.number, kind, entity.previous_origin_world, entity.origin_world,
                last_time_s.value_or(time_s), time_s},
               particles);
}

// An entity has one light: a later one of these takes the place of an earlier.
void Effects::State::shine(const SeenEntity& entity, const math::Vec3& origin_world, bool rocket,
                           double time_s) {
  LightBirth light{.entity = entity.number, .origin_world = origin_world, .born_s = time_s};
  const math::Vec3 above = origin_world + math::Vec3(0, 0, 16);
  const float flicker = light_flicker(entity.number, time_s);
  if (entity.muzzle_flash_now || entity.effects & kEffectMuzzleFlash) {
    LightBirth flash = light;
    const math::Vec3d forward = math::basis_from_angles(entity.angles_deg).forward;
    flash.origin_world = above + math::Vec3(forward * 18.0);
    flash.radius = 200 + flicker;
    flash.least = 32;
    flash.life_s = 0.1;
    lights.add(flash);
  }
  if (entity.effects & kEffectBrightLight) {
    light.origin_world = above;
    light.radius = 400 + flicker;
    lights.add(light);
  }
  light.origin_world = origin_world;
  if (entity.effects & kEffectDimLight) {
    light.radius = 200 + flicker;
    lights.add(light);
  }
  if (rocket) {
    light.radius = 200;
    lights.add(light);
  }
}

std::optional<Beams::Held> Effects::State::held_beam(const Moment& moment) const {
  const SeenEntity* const viewer = find_entity(moment.entities, moment.view_entity);
  if (viewer == nullptr) return std::nullopt;
  return Beams::Held{viewer->number, moment.own_origin_world.value_or(viewer->origin_world)};
}

Effects::Effects(std::uint32_t seed) : state_(std::make_unique<State>(seed)) {}
Effects::~Effects() = default;

void Effects::begin_level() {
  state_->clear();
}

void Effects::resume(const EffectCounts& before) {
  state_->clear();
  state_->count = before;
}

void Effects::count(const Events& events, EffectCounts& io_counts) {
  io_counts.events += static_cast<std::uint32_t>(events.temp_entities.size() + events.particles.size());
  for (const TempEntity& what : events.temp_entities) io_counts.hits += hit_of(what) ? 1 : 0;
  for (const net::Particles& what : events.particles) io_counts.hits += hit_of(what) ? 1 : 0;
}

void Effects::advance(const Events& events, const Moment& moment, const EffectsSettings& settings) {
  State& state = *state_;
  if (state.last_time_s && moment.time_s < *state.last_time_s) state.clear();
  if (!settings.marks && state.marks.size() > 0) state.marks.clear();
  const bool time_passed = !state.last_time_s || moment.time_s > *state.last_time_s;
  state.particles.set_capacity(settings.max_particles);
  // The old first: what has died makes room.
  state.particles.advance(moment.time_s);
  state.lights.advance(moment.time_s);
  state.happen(events, moment, settings.marks);
  if (time_passed) state.go_on(moment);
  state.particles.place_new(moment.time_s);
  state.beams.advance(moment.time_s, state.held_beam(moment));
  state.last_time_s = moment.time_s;
}

render::ParticleCloud Effects::particles() const {
  return state_->particles.cloud();
}

std::size_t Effects::particles_left_out() const {
  return state_->particles.left_out();
}

std::span<const render::DynamicLight> Effects::lights() const {
  return state_->lights.lights();
}

std::span<const BeamPiece> Effects::beams() const {
  return state_->beams.pieces();
}

const render::MarkSet& Effects::marks() const {
  return state_->marks;
}

}  // namespace temblor::client
