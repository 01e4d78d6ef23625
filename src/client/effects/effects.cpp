#include "client/effects/effects.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/hash.h"
#include "client/debris/debris.h"
#include "client/debris/impacts.h"
#include "client/effects/dynamic_lights.h"
#include "client/effects/effect_random.h"
#include "client/effects/hit_marks.h"
#include "client/effects/light_colors.h"
#include "client/effects/particle_bursts.h"
#include "client/effects/particles.h"
#include "client/effects/trails.h"
#include "formats/models/mdl.h"
#include "math/angles.h"
#include "world/visibility.h"

namespace temblor::client {

namespace {

using net::TempEntity;
using net::TempEntityKind;

// A svc_particle message with this count means an explosion. (On the wire it is 255.)
constexpr std::uint16_t kExplosionCount = 1024;

std::optional<BeamModel> find_beam_model(TempEntityKind kind) {
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

// Chips of stone or sparks, in the original's colors.
struct Chips {
  std::uint8_t color;
  std::size_t count;
};
// Returns the chips of an impact; nothing for other effects.
std::optional<Chips> find_chips(TempEntityKind kind) {
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

// Returns how a hit marks the wall; nothing for effects that leave none. Shots end up to 4 units before the
// wall, rockets 8, so the reach is a little more.
std::optional<Hit> find_hit(const TempEntity& what) {
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

// A burst in the palette's row of reds is blood; a larger burst makes a larger splatter.
std::optional<Hit> find_hit(const net::Particles& burst) {
  constexpr std::uint8_t kReds = 64 / 16;
  if (burst.color / 16 != kReds || burst.count == kExplosionCount) return std::nullopt;
  const float radius = std::min(4.0f + static_cast<float>(burst.count) / 8, 16.0f);
  return Hit{render::MarkKind::kSplatter, burst.origin, 48, radius};
}

// Game code knows the surface that it wants marked only as exactly as a message's coordinates.
constexpr float kReachOfRequests = 16;

// Returns the mark that the game asks for; nothing if its picture is missing.
std::optional<Hit> find_hit(const net::MarkRequest& request, const MarkPictures* pictures) {
  Hit hit{.origin_world = request.origin,
          .reach = kReachOfRequests,
          .radius = request.radius,
          .turn_deg = request.turn_deg,
          .is_lasting = true};
  for (const float number : {request.origin.x, request.origin.y, request.origin.z})
    hit.seed = static_cast<std::uint32_t>(base::hash_with(hit.seed, base::float_bits(number)));
  if (request.picture == "*hole") {
    hit.kind = render::MarkKind::kBulletHole;
  } else if (request.picture == "*scorch") {
    hit.kind = render::MarkKind::kScorch;
  } else if (request.picture == "*blood") {
    hit.kind = render::MarkKind::kSplatter;
  } else {
    hit.kind = render::MarkKind::kPicture;
    if (pictures != nullptr) hit.picture = pictures->find(request.picture);
    if (hit.picture == nullptr) return std::nullopt;
  }
  return hit;
}

}  // namespace

float compute_rotated_yaw_deg(double time_s) {
  constexpr double kDegreesPerSecond = 100;
  const double yaw_deg = std::fmod(time_s * kDegreesPerSecond, 360.0);
  return static_cast<float>(yaw_deg < 0 ? yaw_deg + 360 : yaw_deg);
}

struct Effects::State {
  explicit State(std::uint32_t seed_of_all) : seed(seed_of_all), trails(seed_of_all), debris(seed_of_all) {}

  void clear();
  void handle_events(const Events& events, const EffectsInput& input, bool makes_marks);
  EffectRandom make_random() { return EffectRandom(base::hash_with(seed, ++count.events)); }
  void begin(const TempEntity& what, const EffectsInput& input);
  void begin(const net::Particles& what, const EffectsInput& input);
  void mark(std::optional<Hit> hit, const EffectsInput& input);
  void mark(const net::MarkRequest& request, const EffectsInput& input);
  std::span<const render::BrushModelInstance> find_movers(const EffectsInput& input);
  // Effects that entities have as long as they exist: trails, glow and muzzle flashes.
  void advance_entities(const EffectsInput& input);
  void show_shots(const EffectsInput& input);
  void emit_trail(const InterpolatedEntity& entity, TrailKind kind, double time_s);
  void add_lights(const InterpolatedEntity& entity, const math::Vec3& origin_world,
                  std::optional<TrailKind> trail, double time_s);
  void add_beam_light(const TempEntity& beam, double time_s);
  bool show_impact(const BurstContext& burst, const TempEntity& what, const EffectsInput& input);
  math::Vec3 light_color(const math::Vec3& color) const {
    return choices.colored_lights ? color : kWhiteLight;
  }
  std::optional<Beams::Anchor> find_beam_anchor(const EffectsInput& input) const;

  // Seeds the random numbers of all effects.
  std::uint32_t seed;
  // Each event has its own random numbers, which do not depend on earlier frames. Marks count separately, so
  // that particles fly alike with and without marks.
  EffectCounts count;
  ParticlePool particles;
  Trails trails;
  DynamicLights lights;
  EffectsSettings choices;
  Beams beams;
  Debris debris;
  math::Vec3 viewer_velocity{0.0f};
  HitMarks hit_marks;
  render::MarkSet marks;
  bool has_shot_marks = false;
  std::vector<render::BrushModelInstance> movers;  // scratch of find_movers()
  // The time of the last advance(); nothing at the start of a level.
  std::optional<double> last_time_s;
};

void Effects::State::clear() {
  particles.clear();
  trails.clear();
  lights.clear();
  beams.clear();
  debris.clear();
  viewer_velocity = math::Vec3(0.0f);
  marks.clear();
  has_shot_marks = false;
  last_time_s.reset();
}

void Effects::State::handle_events(const Events& events, const EffectsInput& input, bool makes_marks) {
  for (const TempEntity& what : events.temp_entities) {
    begin(what, input);
    if (makes_marks) mark(find_hit(what), input);
  }
  for (const net::Particles& what : events.particles) {
    begin(what, input);
    if (makes_marks) mark(find_hit(what), input);
  }
  for (const net::MarkRequest& request : events.marks) mark(request, input);
  spawn_point_trail(particles, events.leak_path, input.time_s);
}

void Effects::State::begin(const net::Particles& what, const EffectsInput& input) {
  EffectRandom random = make_random();
  const BurstContext burst{particles, random, input.time_s};
  if (what.count == kExplosionCount)
    spawn_explosion(burst, what.origin);
  else
    spawn_chips(burst, what.origin, what.direction, what.color, what.count);
}

// Explosions also flash: a light of 350 units that shrinks by 300 units a second for half a second, as in
// stock Quake.
void Effects::State::begin(const TempEntity& what, const EffectsInput& input) {
  EffectRandom random = make_random();
  const BurstContext burst{particles, random, input.time_s};
  const TimedLight flash{.origin_world = what.origin,
                         .radius = 350,
                         .shrinks_per_second = 300,
                         .born_s = input.time_s,
                         .life_s = 0.5,
                         .color = light_color(kBlastLight)};
  if (const std::optional<Chips> chips = find_chips(what.kind); chips && !show_impact(burst, what, input))
    spawn_chips(burst, what.origin, math::Vec3(0.0f), chips->color, chips->count);
  if (const std::optional<BeamModel> model = find_beam_model(what.kind)) {
    beams.add({what.entity, *model, what.origin, what.end, input.time_s});
    if (choices.colored_lights && *model != BeamModel::kBeam) add_beam_light(what, input.time_s);
  }
  switch (what.kind) {
    case TempEntityKind::kExplosion:
      spawn_explosion(burst, what.origin);
      lights.add(flash);
      if (choices.smoke) debris.show_blast(what.origin, input.time_s, base::hash_with(seed, count.events));
      break;
    case TempEntityKind::kExplosion2:
      spawn_colored_explosion(burst, what.origin, what.color_start, what.color_count);
      lights.add(flash);
      break;
    case TempEntityKind::kTarExplosion:
      spawn_blob_explosion(burst, what.origin);
      break;
    case TempEntityKind::kLavaSplash:
      spawn_lava_splash(burst, what.origin);
      break;
    case TempEntityKind::kTeleport:
      spawn_teleport_splash(burst, what.origin);
      break;
    default:
      break;
  }
}

void Effects::State::mark(std::optional<Hit> hit, const EffectsInput& input) {
  if (!hit) return;
  hit->seed = static_cast<std::uint32_t>(base::mix_bits(++count.hits));
  has_shot_marks = true;
  hit_marks.add(input.level, find_movers(input), *hit, marks);
}

// The marks of a game do not depend on what is in view if it names the model.
void Effects::State::mark(const net::MarkRequest& request, const EffectsInput& input) {
  const std::optional<Hit> hit = find_hit(request, input.mark_pictures);
  if (!hit) return;
  if (!request.model) {
    hit_marks.add(input.level, find_movers(input), *hit, marks);
    return;
  }
  const auto model = static_cast<world::ModelIndex>(*request.model);
  if (std::find(input.submodels.begin(), input.submodels.end(), model) != input.submodels.end())
    hit_marks.add_to_model(input.level, model, *hit, marks);
}

// The brush models in view, where they are drawn.
std::span<const render::BrushModelInstance> Effects::State::find_movers(const EffectsInput& input) {
  movers.clear();
  for (const InterpolatedEntity& entity : input.entities) {
    if (entity.model >= input.submodels.size() || entity.alpha <= 0) continue;
    const world::ModelIndex model = input.submodels[entity.model];
    const auto is_same = [&](const render::BrushModelInstance& other) { return other.model == model; };
    if (model == world::ModelIndex{0} || std::any_of(movers.begin(), movers.end(), is_same)) continue;
    movers.push_back({model, entity.origin_world, entity.angles_deg});
  }
  return movers;
}

// Entities are sorted by number, and static ones (torches) come last. They never move, so they are skipped.
void Effects::State::advance_entities(const EffectsInput& input) {
  for (const InterpolatedEntity& entity : input.entities) {
    if (entity.number >= InterpolatedEntity::kFirstStatic) break;
    const std::uint32_t flags = entity.model < input.model_flags.size() ? input.model_flags[entity.model] : 0;
    const std::optional<TrailKind> trail = find_trail_kind(flags);
    if (trail && entity.is_new) trails.begin(entity.number, entity.origin_world);
    if (trail) emit_trail(entity, *trail, input.time_s);
    const math::Vec3 origin_world_now = entity.number == input.view_entity && input.predicted_origin_world
                                            ? *input.predicted_origin_world
                                            : entity.origin_world;
    if (entity.effects & kEffectBrightField) show_bright_field(particles, input.time_s, origin_world_now);
    add_lights(entity, origin_world_now, trail, input.time_s);
    if (choices.splashes) debris.show_splash(entity, input, particles);
  }
}

// A flash arrives once, perhaps at the time of the last frame. Only the viewer's casings are near enough for
// its speed to matter.
void Effects::State::show_shots(const EffectsInput& input) {
  constexpr float kMaxSpeed = 1000;
  const double elapsed_s = input.time_s - last_time_s.value_or(input.time_s);
  const InterpolatedEntity* const viewer = find_entity(input.entities, input.view_entity);
  if (viewer != nullptr && elapsed_s > 0) {
    const math::Vec3 moved = viewer->origin_world - viewer->previous_origin_world;
    viewer_velocity = moved / static_cast<float>(elapsed_s);
    if (glm::length(viewer_velocity) > kMaxSpeed) viewer_velocity = math::Vec3(0.0f);
  }
  for (const InterpolatedEntity& entity : input.entities)
    if (entity.has_muzzle_flash)
      debris.show_shot(entity, input, &entity == viewer ? viewer_velocity : math::Vec3(0.0f), choices);
}

// The piece of path since the last frame; its particles are born at times between the two frames.
void Effects::State::emit_trail(const InterpolatedEntity& entity, TrailKind kind, double time_s) {
  trails.emit({entity.number, kind, entity.previous_origin_world, entity.origin_world,
               last_time_s.value_or(time_s), time_s},
              particles);
}

// Where lightning ends. An entity's next bolt moves its light there, as the number's highest bit keeps it
// apart from the entity's own light.
void Effects::State::add_beam_light(const TempEntity& beam, double time_s) {
  constexpr std::uint32_t kBeamBit = 1u << 31;
  constexpr float kBeforeEnd = 8;  // units, so that the light is not in the wall
  const math::Vec3 path = beam.end - beam.origin;
  const float length = glm::length(path);
  if (length <= kBeforeEnd) return;
  lights.add({.entity = beam.entity | kBeamBit,
              .origin_world = beam.end - path * (kBeforeEnd / length),
              .radius = 200 + light_flicker(beam.entity, time_s),
              .born_s = time_s,
              .life_s = Beams::kLife_s,
              .color = kLightningLight});
}

// Returns false if the original's chips are to be shown.
bool Effects::State::show_impact(const BurstContext& burst, const TempEntity& what,
                                 const EffectsInput& input) {
  if (what.kind != TempEntityKind::kGunshot && what.kind != TempEntityKind::kSpike &&
      what.kind != TempEntityKind::kSuperSpike)
    return false;
  if (is_liquid_contents(world::point_contents(input.level, what.origin, input.liquids))) {
    if (choices.splashes) debris.show_hit_in_liquid(burst, what.origin, input);
    return choices.splashes;
  }
  if (!choices.impacts) return false;
  const std::optional<Hit> hit = find_hit(what);
  const std::optional<HitMarks::Surface> surface =
      hit_marks.find_surface(input.level, find_movers(input), *hit);
  if (!surface) return false;
  const world::Texture& texture = input.level.texture(input.level.face(surface->face).texture);
  spawn_impact(burst, {what.origin, surface->normal_world, find_material(texture.name)}, debris.puffs());
  return true;
}

// An entity has one light: a later one of these replaces an earlier one.
void Effects::State::add_lights(const InterpolatedEntity& entity, const math::Vec3& origin_world,
                                std::optional<TrailKind> trail, double time_s) {
  TimedLight light{.entity = entity.number,
                   .origin_world = origin_world,
                   .born_s = time_s,
                   .color = light_color(choose_glow_color(entity.effects, trail))};
  const math::Vec3 above = origin_world + math::Vec3(0, 0, 16);
  const float flicker = light_flicker(entity.number, time_s);
  if (choices.muzzle_flashes && (entity.has_muzzle_flash || entity.effects & kEffectMuzzleFlash)) {
    TimedLight flash = light;
    const math::Vec3d forward = math::basis_from_angles(entity.angles_deg).forward;
    flash.origin_world = above + math::Vec3(forward * 18.0);
    flash.radius = 200 + flicker;
    flash.min_light = 32;
    flash.life_s = 0.1;
    flash.color = light_color(beams.has_bolt(entity.number) ? kLightningLight : kShotLight);
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
  if (trail == TrailKind::kRocket) {
    light.radius = 200;
    lights.add(light);
  }
}

std::optional<Beams::Anchor> Effects::State::find_beam_anchor(const EffectsInput& input) const {
  if (choices.barrel_beams && input.held_gun)
    return Beams::Anchor{input.view_entity, input.held_gun->muzzle_world};
  const InterpolatedEntity* const viewer = find_entity(input.entities, input.view_entity);
  if (viewer == nullptr) return std::nullopt;
  return Beams::Anchor{viewer->number, input.predicted_origin_world.value_or(viewer->origin_world)};
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
  for (const TempEntity& what : events.temp_entities) io_counts.hits += find_hit(what) ? 1 : 0;
  for (const net::Particles& what : events.particles) io_counts.hits += find_hit(what) ? 1 : 0;
}

void Effects::advance(const Events& events, const EffectsInput& input, const EffectsSettings& settings) {
  State& state = *state_;
  if (state.last_time_s && input.time_s < *state.last_time_s) state.clear();
  if (!settings.marks && state.has_shot_marks) {
    state.marks.remove_shots();
    state.has_shot_marks = false;
  }
  // Two frames at the same time (a paused game) must not emit trails twice.
  const bool time_passed = !state.last_time_s || input.time_s > *state.last_time_s;
  state.particles.set_capacity(settings.max_particles);
  state.choices = settings;
  // Advances old effects first, so that dead ones make room.
  state.particles.advance(input.time_s);
  state.lights.advance(input.time_s);
  state.handle_events(events, input, settings.marks);
  state.show_shots(input);
  if (time_passed) state.advance_entities(input);
  state.particles.place_new(input.time_s);
  state.debris.advance(input.time_s);
  state.beams.advance(input.time_s, state.find_beam_anchor(input));
  state.last_time_s = input.time_s;
}

render::ParticleCloud Effects::particles() const {
  return state_->particles.cloud();
}

std::size_t Effects::dropped_particles() const {
  return state_->particles.dropped();
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

std::span<const CasingPiece> Effects::casings() const {
  return state_->debris.casings();
}

std::span<const Puff> Effects::puffs() const {
  return state_->debris.puffs().puffs();
}

}  // namespace temblor::client
