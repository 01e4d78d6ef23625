#include "client/effects/trails.h"

#include <algorithm>
#include <cmath>

#include "formats/models/mdl.h"

namespace temblor::client {

namespace {

constexpr double kSpacing = 3;  // units of way for a particle
constexpr float kScatter = 3, kVoorScatter = 8;

double spacing(TrailKind kind) {
  return kind == TrailKind::kThinBlood ? 2 * kSpacing : kSpacing;
}

// Tracers part to both sides in turn, in two shades.
void make_tracer(const math::Vec3d& direction, std::uint8_t color, std::uint32_t count,
                 ParticleBirth& io_birth) {
  constexpr double kSidewaysSpeed = 30;
  const double side = count % 2 == 0 ? -kSidewaysSpeed : kSidewaysSpeed;
  io_birth.velocity = math::Vec3(math::Vec3d(direction.y, -direction.x, 0) * side);
  io_birth.life_s = 0.5f;
  io_birth.color = static_cast<std::uint8_t>(color + (count / 4 % 2) * 8);
}

ParticleBirth one_of_trail(TrailKind kind, const math::Vec3d& direction, std::uint32_t count,
                           EffectRandom& io_random) {
  ParticleBirth birth;
  birth.life_s = 2;
  switch (kind) {
    case TrailKind::kRocket:
    case TrailKind::kGrenade:
      birth.origin_world = io_random.in_cube(kScatter);
      birth.motion = ParticleMotion::kFire;
      birth.ramp = static_cast<float>(io_random.below(4) + (kind == TrailKind::kGrenade ? 2u : 0u));
      break;
    case TrailKind::kBlood:
    case TrailKind::kThinBlood:
      birth.origin_world = io_random.in_cube(kScatter);
      birth.motion = ParticleMotion::kFalling;
      birth.color = static_cast<std::uint8_t>(67 + io_random.below(4));
      break;
    case TrailKind::kTracer:
      make_tracer(direction, 52, count, birth);
      break;
    case TrailKind::kTracer2:
      make_tracer(direction, 230, count, birth);
      break;
    case TrailKind::kVoor:
      birth.origin_world = io_random.in_cube(kVoorScatter);
      birth.life_s = 0.3f;
      birth.color = static_cast<std::uint8_t>(152 + io_random.below(4));
      break;
  }
  return birth;
}

}  // namespace

std::optional<TrailKind> trail_kind(std::uint32_t model_flags) {
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
  carried_.clear();
}

Trails::Carried& Trails::carried(std::uint32_t entity) {
  while (carried_.size() <= entity)
    carried_.push_back({EffectRandom(base::hash_with(seed_, carried_.size()))});
  return carried_[entity];
}

void Trails::begin(std::uint32_t entity, const math::Vec3& origin_world) {
  std::uint64_t hash = base::hash_with(seed_, entity);
  for (int axis = 0; axis < 3; ++axis) hash = base::hash_with(hash, base::bits_of(origin_world[axis]));
  carried(entity) = {EffectRandom(hash)};
}

void Trails::leave(const TrailPiece& piece, ParticlePool& io_pool) {
  const math::Vec3d from(piece.from_world), way = math::Vec3d(piece.to_world) - from;
  const double length = glm::length(way);
  if (length == 0) return;
  Carried& carried = this->carried(piece.entity);
  const math::Vec3d direction = way / length;
  const double step = spacing(piece.kind);
  const double due = std::max(0.0, std::ceil((length - carried.until_next) / step));
  // A way of any length takes no longer than the room for particles allows.
  const double given = std::min(due, static_cast<double>(io_pool.room()));
  for (double i = 0; i < given; ++i) {
    const double passed = carried.until_next + i * step;
    ParticleBirth birth = one_of_trail(piece.kind, direction, carried.count++, carried.random);
    birth.origin_world += math::Vec3(from + direction * passed);
    birth.born_s = std::lerp(piece.from_time_s, piece.to_time_s, passed / length);
    io_pool.add(birth);
  }
  io_pool.leave_out(static_cast<std::size_t>(due - given));
  carried.until_next = std::clamp(carried.until_next + due * step - length, 0.0, step);
}

}  // namespace temblor::client
