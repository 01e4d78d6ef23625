#include "client/effects/beams.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/hash.h"

namespace temblor::client {

namespace {

constexpr double kRollStep_s = 0.05;

float degrees(double radians) {
  const double deg = radians * (180 / std::numbers::pi);
  return static_cast<float>(deg < 0 ? deg + 360 : deg);
}

// A piece keeps its turn for a step of time.
float roll_deg(const Beam& beam, std::uint32_t piece, double time_s) {
  const auto step = static_cast<std::int64_t>(std::floor(time_s / kRollStep_s));
  const std::uint64_t hash =
      base::hash_with(base::hash_with(beam.entity, piece), static_cast<std::uint64_t>(step));
  return static_cast<float>(hash % 360);
}

}  // namespace

void Beams::clear() {
  size_ = 0;
  pieces_.clear();
}

void Beams::add(const Beam& beam) {
  const std::size_t slot = slot_for(beam.entity);
  beams_[slot] = beam;
  size_ = std::max(size_, slot + 1);
}

std::size_t Beams::slot_for(std::uint32_t entity) const {
  if (entity != 0)
    for (std::size_t i = 0; i < size_; ++i)
      if (beams_[i].entity == entity) return i;
  if (size_ < kMost) return size_;
  const auto oldest = std::min_element(beams_.begin(), beams_.end(),
                                       [](const Beam& a, const Beam& b) { return a.born_s < b.born_s; });
  return static_cast<std::size_t>(oldest - beams_.begin());
}

void Beams::advance(double time_s, const std::optional<Held>& held) {
  pieces_.clear();
  std::size_t kept = 0;
  for (std::size_t i = 0; i < size_; ++i) {
    Beam beam = beams_[i];
    if (beam.born_s + kLife_s < time_s) continue;
    if (held && beam.entity == held->entity) beam.start_world = held->origin_world;
    beams_[kept++] = beam;
    lay_out(beam, time_s);
  }
  size_ = kept;
}

void Beams::lay_out(const Beam& beam, double time_s) {
  const math::Vec3d start(beam.start_world), way = math::Vec3d(beam.end_world) - start;
  const double length = glm::length(way);
  if (length == 0) return;
  const double level_length = std::hypot(way.x, way.y);
  const float pitch_deg = degrees(std::atan2(way.z, level_length));
  const float yaw_deg = level_length > 0 ? degrees(std::atan2(way.y, way.x)) : 0.0f;
  const double count = std::min(std::ceil(length / double{kPieceLength}), double{kMaxPieces});
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(count); ++i) {
    const math::Vec3d place = start + way * (i * double{kPieceLength} / length);
    pieces_.push_back({beam.model, math::Vec3(place), {pitch_deg, yaw_deg, roll_deg(beam, i, time_s)}});
  }
}

}  // namespace temblor::client
