// With dv/dt = k v + a and v(0) = v0, the distance after t seconds is
//
//   v0 f + (a / k) (f - t)    where f = (e^kt - 1) / k,
//   v0 t + a t^2 / 2          for k = 0.
//
// f and the fall depend only on motion and age, so the particles of a burst share them.
#include "client/effects/particles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace temblor::client {

namespace {

// Units/s^2: a twentieth of the gravity of bodies (sv_gravity 800), as in the original.
constexpr double kGravity = 40;
constexpr double kGravityOfBodies = 800;

// Palette indices from hot to cold, from the original except those of sparks.
constexpr std::array<std::uint8_t, 8> kExplodeRamp = {0x6f, 0x6d, 0x6b, 0x69, 0x67, 0x65, 0x63, 0x61};
constexpr std::array<std::uint8_t, 8> kExplode2Ramp = {0x6f, 0x6e, 0x6d, 0x6c, 0x6b, 0x6a, 0x68, 0x66};
constexpr std::array<std::uint8_t, 8> kSparkRamp = {0xef, 0xee, 0xec, 0xea, 0xe8, 0xe6, 0xe4, 0xe2};
constexpr std::array<std::uint8_t, 6> kFireRamp = {0x6d, 0x6b, 0x06, 0x05, 0x04, 0x03};

// How a kind of particle moves and changes its color; see ParticleMotion.
struct MotionLaw {
  // k of the equation above, per second.
  double growth_horizontal, growth_vertical;
  // a of the equation above, units/s^2, of z only.
  double rise;
  // Colors per second.
  float ramp_rate;
  // Empty: the particle keeps its color.
  std::span<const std::uint8_t> ramp;
};

// In the order of ParticleMotion.
constexpr std::array<MotionLaw, kParticleMotions> kLaws = {{
    {0, 0, 0, 0, {}},
    {0, 0, -kGravity, 0, {}},
    {0, 0, kGravity, 5, kFireRamp},
    {4, 4, -kGravity, 10, kExplodeRamp},
    {-1, -1, -kGravity, 15, kExplode2Ramp},
    {4, 4, -kGravity, 0, {}},
    {-4, 0, -kGravity, 0, {}},
    {-3, -3, -kGravityOfBodies, 16, kSparkRamp},
    {0, 0, -kGravityOfBodies, 0, {}},
}};

const MotionLaw& find_law(ParticleMotion motion) {
  return kLaws[static_cast<std::size_t>(motion)];
}

// Returns f of the equation above: the distance that a particle with speed 1 covers. expm1 keeps it exact for
// small ages.
double compute_unit_distance(double growth, double age_s) {
  return growth == 0 ? age_s : std::expm1(growth * age_s) / growth;
}

// The motion at an age, common to all particles of one kind: place = origin + velocity * (horizontal or
// vertical), plus the rise in z.
struct Displacement {
  double born_s = std::numeric_limits<double>::quiet_NaN();
  float horizontal = 0, vertical = 0, rise = 0;
};

Displacement compute_displacement(const MotionLaw& law, double born_s, double age_s) {
  const double vertical = compute_unit_distance(law.growth_vertical, age_s);
  const double rise = law.growth_vertical == 0 ? law.rise * age_s * age_s / 2
                                               : law.rise * (vertical - age_s) / law.growth_vertical;
  return {born_s, static_cast<float>(compute_unit_distance(law.growth_horizontal, age_s)),
          static_cast<float>(vertical), static_cast<float>(rise)};
}

// The color on the ramp at an age, from the ramp position at which the particle started.
std::uint8_t find_color(const MotionLaw& law, std::uint8_t born_color, float ramp, double age_s) {
  if (law.ramp.empty()) return born_color;
  const auto step = static_cast<std::size_t>(double{ramp} + double{law.ramp_rate} * age_s);
  return law.ramp[std::min(step, law.ramp.size() - 1)];
}

}  // namespace

// Reserves memory for all particles, so that playing allocates nothing later.
void ParticlePool::set_capacity(std::size_t capacity) {
  capacity_ = capacity;
  for (int axis = 0; axis < 3; ++axis)
    for (auto* values : {&origin_, &velocity_, &place_})
      (*values)[static_cast<std::size_t>(axis)].reserve(capacity);
  born_s_.reserve(capacity);
  life_s_.reserve(capacity);
  ramp_.reserve(capacity);
  motion_.reserve(capacity);
  born_color_.reserve(capacity);
  color_.reserve(capacity);
}

void ParticlePool::clear() {
  resize(0);
  placed_ = 0;
  dropped_ = 0;
}

bool ParticlePool::add(const ParticleSpawn& particle) {
  if (room() == 0) {
    ++dropped_;
    return false;
  }
  const MotionLaw& law = find_law(particle.motion);
  // A particle dies when it reaches the end of its ramp, even if its time is not over.
  float life_s = particle.life_s;
  if (!law.ramp.empty())
    life_s = std::min(life_s, (static_cast<float>(law.ramp.size()) - particle.ramp) / law.ramp_rate);
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    origin_[a].push_back(particle.origin_world[axis]);
    velocity_[a].push_back(particle.velocity[axis]);
  }
  born_s_.push_back(particle.born_s);
  life_s_.push_back(life_s);
  ramp_.push_back(particle.ramp);
  motion_.push_back(particle.motion);
  born_color_.push_back(particle.color);
  return true;
}

void ParticlePool::advance(double time_s) {
  place(0, time_s);
}

void ParticlePool::place_new(double time_s) {
  place(placed_, time_s);
}

// Moves particles from `first` on and removes dead ones, keeping the order of the others. Neighbors usually
// belong to one burst, so the displacement of the last particle of each kind is reused while the birth time
// is the same.
void ParticlePool::place(std::size_t first, double time_s) {
  for (std::vector<float>& values : place_) values.resize(size());
  color_.resize(size());
  std::array<Displacement, kParticleMotions> displacements;
  std::size_t kept = first;
  for (std::size_t i = first; i < size(); ++i) {
    const double age_s = time_s - born_s_[i];
    if (age_s > double{life_s_[i]}) continue;
    move_particle(i, kept);
    const MotionLaw& law = find_law(motion_[kept]);
    Displacement& now = displacements[static_cast<std::size_t>(motion_[kept])];
    if (now.born_s != born_s_[kept]) now = compute_displacement(law, born_s_[kept], age_s);
    place_[0][kept] = origin_[0][kept] + velocity_[0][kept] * now.horizontal;
    place_[1][kept] = origin_[1][kept] + velocity_[1][kept] * now.horizontal;
    place_[2][kept] = origin_[2][kept] + velocity_[2][kept] * now.vertical + now.rise;
    color_[kept] = find_color(law, born_color_[kept], ramp_[kept], age_s);
    ++kept;
  }
  resize(kept);
  placed_ = kept;
}

// Copies a particle's constant values to another index, to close gaps.
void ParticlePool::move_particle(std::size_t from, std::size_t to) {
  if (from == to) return;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    origin_[axis][to] = origin_[axis][from];
    velocity_[axis][to] = velocity_[axis][from];
  }
  born_s_[to] = born_s_[from];
  life_s_[to] = life_s_[from];
  ramp_[to] = ramp_[from];
  motion_[to] = motion_[from];
  born_color_[to] = born_color_[from];
}

void ParticlePool::resize(std::size_t size) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    origin_[axis].resize(size);
    velocity_[axis].resize(size);
    place_[axis].resize(size);
  }
  born_s_.resize(size);
  life_s_.resize(size);
  ramp_.resize(size);
  motion_.resize(size);
  born_color_.resize(size);
  color_.resize(size);
}

render::ParticleCloud ParticlePool::cloud() const {
  return {place_[0], place_[1], place_[2], color_};
}

}  // namespace temblor::client
