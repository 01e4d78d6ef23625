// With dv/dt = k v + a and v(0) = v0: the way after t seconds is v0 f + (a / k) (f - t), f = (e^kt - 1) / k;
// for k = 0 it is v0 t + a t^2 / 2. What f and the fall are depends on motion and age alone, so a burst's
// particles, which are all of one age, share them.
#include "client/effects/particles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace temblor::client {

namespace {

constexpr double kGravity = 40;  // a twentieth of what bodies fall with

constexpr std::array<std::uint8_t, 8> kExplodeRamp = {0x6f, 0x6d, 0x6b, 0x69, 0x67, 0x65, 0x63, 0x61};
constexpr std::array<std::uint8_t, 8> kExplode2Ramp = {0x6f, 0x6e, 0x6d, 0x6c, 0x6b, 0x6a, 0x68, 0x66};
constexpr std::array<std::uint8_t, 6> kFireRamp = {0x6d, 0x6b, 0x06, 0x05, 0x04, 0x03};

struct Law {
  double growth_horizontal, growth_vertical;  // k
  double rise;                                // a, of z
  float ramp_rate;                            // steps a second
  std::span<const std::uint8_t> ramp;         // empty: one color
};

constexpr std::array<Law, kParticleMotions> kLaws = {{
    {0, 0, 0, 0, {}},
    {0, 0, -kGravity, 0, {}},
    {0, 0, kGravity, 5, kFireRamp},
    {4, 4, -kGravity, 10, kExplodeRamp},
    {-1, -1, -kGravity, 15, kExplode2Ramp},
    {4, 4, -kGravity, 0, {}},
    {-4, 0, -kGravity, 0, {}},
}};

const Law& law_of(ParticleMotion motion) {
  return kLaws[static_cast<std::size_t>(motion)];
}

double way_for_unit_velocity(double growth, double age_s) {
  return growth == 0 ? age_s : std::expm1(growth * age_s) / growth;
}

// What an age means for all particles of one motion: place = origin + velocity * way, and z rises.
struct Passage {
  double born_s = std::numeric_limits<double>::quiet_NaN();
  float way_horizontal = 0, way_vertical = 0, rise = 0;
};

Passage passage(const Law& law, double born_s, double age_s) {
  const double vertical = way_for_unit_velocity(law.growth_vertical, age_s);
  const double rise = law.growth_vertical == 0 ? law.rise * age_s * age_s / 2
                                               : law.rise * (vertical - age_s) / law.growth_vertical;
  return {born_s, static_cast<float>(way_for_unit_velocity(law.growth_horizontal, age_s)),
          static_cast<float>(vertical), static_cast<float>(rise)};
}

std::uint8_t color_at(const Law& law, std::uint8_t born_color, float ramp, double age_s) {
  if (law.ramp.empty()) return born_color;
  const auto step = static_cast<std::size_t>(double{ramp} + double{law.ramp_rate} * age_s);
  return law.ramp[std::min(step, law.ramp.size() - 1)];
}

}  // namespace

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
  left_out_ = 0;
}

bool ParticlePool::add(const ParticleBirth& birth) {
  if (room() == 0) {
    ++left_out_;
    return false;
  }
  const Law& law = law_of(birth.motion);
  float life_s = birth.life_s;
  if (!law.ramp.empty())
    life_s = std::min(life_s, (static_cast<float>(law.ramp.size()) - birth.ramp) / law.ramp_rate);
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    origin_[a].push_back(birth.origin_world[axis]);
    velocity_[a].push_back(birth.velocity[axis]);
  }
  born_s_.push_back(birth.born_s);
  life_s_.push_back(life_s);
  ramp_.push_back(birth.ramp);
  motion_.push_back(birth.motion);
  born_color_.push_back(birth.color);
  return true;
}

void ParticlePool::advance(double time_s) {
  place(0, time_s);
}

void ParticlePool::place_new(double time_s) {
  place(placed_, time_s);
}

void ParticlePool::place(std::size_t first, double time_s) {
  for (std::vector<float>& values : place_) values.resize(size());
  color_.resize(size());
  std::array<Passage, kParticleMotions> passages;
  std::size_t kept = first;
  for (std::size_t i = first; i < size(); ++i) {
    const double age_s = time_s - born_s_[i];
    if (age_s > double{life_s_[i]}) continue;
    keep(i, kept);
    const Law& law = law_of(motion_[kept]);
    Passage& now = passages[static_cast<std::size_t>(motion_[kept])];
    if (now.born_s != born_s_[kept]) now = passage(law, born_s_[kept], age_s);
    place_[0][kept] = origin_[0][kept] + velocity_[0][kept] * now.way_horizontal;
    place_[1][kept] = origin_[1][kept] + velocity_[1][kept] * now.way_horizontal;
    place_[2][kept] = origin_[2][kept] + velocity_[2][kept] * now.way_vertical + now.rise;
    color_[kept] = color_at(law, born_color_[kept], ramp_[kept], age_s);
    ++kept;
  }
  resize(kept);
  placed_ = kept;
}

void ParticlePool::keep(std::size_t from, std::size_t to) {
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
