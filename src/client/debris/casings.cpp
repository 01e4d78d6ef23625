#include "client/debris/casings.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "client/effects/effect_random.h"
#include "world/trace.h"
#include "world/visibility.h"

namespace temblor::client {

namespace {

constexpr float kBodyGravity = 800;    // units/s^2
constexpr float kCasingRadius = 0.6f;  // of a casing, units

math::Vec3 fly(const CasingLeg& leg, double after_s) {
  const auto t = static_cast<float>(after_s);
  return leg.origin_world + leg.velocity * t - math::Vec3(0, 0, kBodyGravity * t * t / 2);
}

struct Bounce {
  double after_s;  // from the leg's start
  math::Vec3 place_world, normal;
};

// Follows a leg's parabola in short lines to the first surface. Nothing if it flies on for long.
std::optional<Bounce> find_bounce(const world::Level& level, const CasingLeg& leg) {
  constexpr double kStep_s = 0.04;
  constexpr int kMaxSteps = 50;
  math::Vec3 from = leg.origin_world;
  for (int i = 1; i <= kMaxSteps; ++i) {
    const math::Vec3 to = fly(leg, i * kStep_s);
    const world::Trace trace = world::trace_line(level, world::ModelIndex{0}, world::Hull::kPoint, from, to);
    if (trace.fraction < 1)
      return Bounce{(i - 1 + double{trace.fraction}) * kStep_s, trace.end, trace.plane_normal};
    from = to;
  }
  return std::nullopt;
}

// Brass keeps less than half of its speed across a surface and more along it.
math::Vec3 reflect(const math::Vec3& velocity, const math::Vec3& normal) {
  constexpr float kAcross = 0.4f, kAlong = 0.65f;
  const math::Vec3 across = normal * glm::dot(velocity, normal);
  return (velocity - across) * kAlong - across * kAcross;
}

}  // namespace

void Casings::compute_legs(const world::Level& level, Casing& io_casing) {
  constexpr float kFloor = 0.7f, kSlow = 60;
  io_casing.legs[0] = {0, io_casing.thrown.origin_world, io_casing.thrown.velocity, false};
  io_casing.leg_count = 1;
  while (io_casing.leg_count < kMaxLegs) {
    const CasingLeg& leg = io_casing.legs[io_casing.leg_count - 1];
    const std::optional<Bounce> bounce = find_bounce(level, leg);
    if (!bounce) return;
    const math::Vec3 falling(0, 0, -kBodyGravity * static_cast<float>(bounce->after_s));
    CasingLeg next{leg.start_s + bounce->after_s, bounce->place_world + bounce->normal * kCasingRadius,
                   reflect(leg.velocity + falling, bounce->normal), false};
    const bool is_slow = bounce->normal.z > kFloor && glm::length(next.velocity) < kSlow;
    next.is_rest = is_slow || io_casing.leg_count + 1 == kMaxLegs;
    io_casing.legs[io_casing.leg_count++] = next;
    if (next.is_rest) return;
  }
}

void Casings::throw_casing(const world::Level& level, const CasingThrow& thrown) {
  if (world::point_contents(level, thrown.origin_world) == world::Contents::kSolid) return;
  std::size_t slot = size_;
  if (size_ < kMaxCasings) {
    ++size_;
  } else {
    const auto is_older = [](const Casing& a, const Casing& b) { return a.thrown.born_s < b.thrown.born_s; };
    slot = static_cast<std::size_t>(std::min_element(casings_.begin(), casings_.end(), is_older) -
                                    casings_.begin());
  }
  casings_[slot].thrown = thrown;
  compute_legs(level, casings_[slot]);
}

// In the air a casing tumbles; at rest it lies.
CasingPiece Casings::place(const Casing& casing, double age_s) {
  const auto legs_end = casing.legs.begin() + static_cast<std::ptrdiff_t>(casing.leg_count);
  const auto later = std::find_if(casing.legs.begin() + 1, legs_end,
                                  [&](const CasingLeg& leg) { return leg.start_s > age_s; });
  const CasingLeg& leg = *(later - 1);
  EffectRandom random(casing.thrown.seed);
  const float yaw = random.uniform(0, 360), yaw_speed = random.uniform(-700, 700);
  const float pitch_speed = random.uniform(-1100, 1100);
  const auto turned_s = static_cast<float>(leg.is_rest ? leg.start_s : age_s);
  CasingPiece piece{.model = casing.thrown.model};
  piece.origin_world = leg.is_rest ? leg.origin_world : fly(leg, age_s - leg.start_s);
  piece.angles_deg = {leg.is_rest ? 0.0f : std::fmod(pitch_speed * turned_s, 360.0f),
                      std::fmod(yaw + yaw_speed * turned_s, 360.0f), 0};
  piece.alpha = static_cast<float>(std::clamp((kLife_s - age_s) / kFade_s, 0.0, 1.0));
  return piece;
}

void Casings::advance(double time_s) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < size_; ++i) {
    const double age_s = time_s - casings_[i].thrown.born_s;
    if (age_s >= kLife_s) continue;
    if (kept != i) casings_[kept] = casings_[i];
    pieces_[kept++] = place(casings_[i], std::max(age_s, 0.0));
  }
  size_ = piece_count_ = kept;
}

}  // namespace temblor::client
