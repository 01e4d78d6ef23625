#include "client/effects/trails.h"

#include <algorithm>
#include <cmath>

#include "formats/models/mdl.h"

namespace temblor::client {

namespace {

constexpr double kSpacing = 3;  // units of path per particle
constexpr float kScatter = 3, kVoorScatter = 8;

double get_spacing(TrailKind kind) {
  return kind == TrailKind::kThinBlood ? 2 * kSpacing : kSpacing;
}

// Tracer particles drift to alternating sides, in two shades.
void make_tracer(const math::Vec3d& direction, std::uint8_t color, std::uint32_t count,
                 ParticleSpawn& io_particle) {
  constexpr double kSidewaysSpeed = 30;
  const double side = count % 2 == 0 ? -kSidewaysSpeed : kSidewaysSpeed;
  io_particle.velocity = math::Vec3(math::Vec3d(direction.y, -direction.x, 0) * side);
  io_particle.life_s = 0.5f;
  io_particle.color = static_cast<std::uint8_t>(color + (count / 4 % 2) * 8);
}

// Lifetimes, colors and scatter of the original's trails. `count` numbers the particles of a trail.
ParticleSpawn make_trail_particle(TrailKind kind, const math::Vec3d& direction, std::uint32_t count,
                                  EffectRandom& io_random) {
  ParticleSpawn particle;
  particle.life_s = 2;
  switch (kind) {
    case TrailKind::kRocket:
    case TrailKind::kGrenade:
      particle.origin_world = io_random.uniform_in_cube(kScatter);
      particle.motion = ParticleMotion::kFire;
      particle.ramp = static_cast<float>(io_random.below(4) + (kind == TrailKind::kGrenade ? 2u : 0u));
      break;
    case TrailKind::kBlood:
    case TrailKind::kThinBlood:
      particle.origin_world = io_random.uniform_in_cube(kScatter);
      particle.motion = ParticleMotion::kFalling;
      particle.color = static_cast<std::uint8_t>(67 + io_random.below(4));
      break;
    case TrailKind::kTracer:
      make_tracer(direction, 52, count, particle);
      break;
    case TrailKind::kTracer2:
      make_tracer(direction, 230, count, particle);
      break;
    case TrailKind::kVoor:
      particle.origin_world = io_random.uniform_in_cube(kVoorScatter);
      particle.life_s = 0.3f;
      particle.color = static_cast<std::uint8_t>(152 + io_random.below(4));
      break;
  }
  return particle;
}

}  // namespace

std::optional<TrailKind> find_trail_kind(std::uint32_t model_flags) {
  using enum formats::MdlFlags;
  if (model_flags & kMdlGibBlood) return TrailKind::kBlood;
  if (model_flags & kMdlZombieBlood) return TrailKind::kThinBlood;
  if (model_flags & kMdlTracer) return TrailKind::kTracer;
  if (model_flags & kMdlTracer2) return TrailKind::kTracer2;
  if (model_flags & kMdlRocketTrail) return TrailKind::kRocket;
  if (model_flags & kMdlGrenadeSmoke) return TrailKind::kGrenade;
  if (model_flags & kMdlTracer3) return TrailKind::kVoor;
  return std::nullopt;
}

void Trails::clear() {
  emitters_.clear();
}

// Grows the list to the entity's number. New emitters are seeded by their number.
Trails::Emitter& Trails::get_emitter(std::uint32_t entity) {
  while (emitters_.size() <= entity)
    emitters_.push_back({EffectRandom(base::hash_with(seed_, emitters_.size()))});
  return emitters_[entity];
}

// Seeds by place as well, so that two rockets of one entity slot scatter differently.
void Trails::begin(std::uint32_t entity, const math::Vec3& origin_world) {
  std::uint64_t hash = base::hash_with(seed_, entity);
  for (int axis = 0; axis < 3; ++axis) hash = base::hash_with(hash, base::float_bits(origin_world[axis]));
  get_emitter(entity) = {EffectRandom(hash)};
}

// Particles are due at the distances until_next, until_next + step, ... along the piece:
//
//   from o--------o-------o-------o---| to
//   until_next -->|  step |       |   |<- the rest carries over
void Trails::emit(const TrailPiece& piece, ParticlePool& io_pool) {
  const math::Vec3d from(piece.from_world), path = math::Vec3d(piece.to_world) - from;
  const double length = glm::length(path);
  if (length == 0) return;
  Emitter& get_emitter = this->get_emitter(piece.entity);
  const math::Vec3d direction = path / length;
  const double step = get_spacing(piece.kind);
  const double due = std::max(0.0, std::ceil((length - get_emitter.until_next) / step));
  // However long the path is, the work is limited by the room for particles.
  const double given = std::min(due, static_cast<double>(io_pool.room()));
  for (double i = 0; i < given; ++i) {
    const double passed = get_emitter.until_next + i * step;
    ParticleSpawn particle =
        make_trail_particle(piece.kind, direction, get_emitter.count++, get_emitter.random);
    particle.origin_world += math::Vec3(from + direction * passed);
    particle.born_s = std::lerp(piece.from_time_s, piece.to_time_s, passed / length);
    io_pool.add(particle);
  }
  io_pool.count_dropped(static_cast<std::size_t>(due - given));
  get_emitter.until_next = std::clamp(get_emitter.until_next + due * step - length, 0.0, step);
}

}  // namespace temblor::client
