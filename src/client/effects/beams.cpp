#include "client/effects/beams.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/hash.h"

namespace temblor::client {

namespace {

// How long a piece keeps its rotation. Stock Quake chose a new one in every frame.
constexpr double kRollStep_s = 0.05;

// Converts to [0, 360), as the angles of models are.
float to_positive_degrees(double radians) {
  const double deg = radians * (180 / std::numbers::pi);
  return static_cast<float>(deg < 0 ? deg + 360 : deg);
}

// The random rotation of a piece about the beam; it lasts for a step of time. A hash instead of a generator
// makes it independent of the frame rate and of other beams.
float compute_roll_deg(const Beam& beam, std::uint32_t piece, double time_s) {
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
  const std::size_t slot = find_slot(beam.entity);
  beams_[slot] = beam;
  size_ = std::max(size_, slot + 1);
}

// Returns the entity's own slot, a free one, or the oldest beam's.
std::size_t Beams::find_slot(std::uint32_t entity) const {
  if (entity != 0)
    for (std::size_t i = 0; i < size_; ++i)
      if (beams_[i].entity == entity) return i;
  if (size_ < kMaxBeams) return size_;
  const auto oldest = std::min_element(beams_.begin(), beams_.end(),
                                       [](const Beam& a, const Beam& b) { return a.born_s < b.born_s; });
  return static_cast<std::size_t>(oldest - beams_.begin());
}

void Beams::advance(double time_s, const std::optional<Anchor>& anchor) {
  pieces_.clear();
  std::size_t kept = 0;
  for (std::size_t i = 0; i < size_; ++i) {
    Beam beam = beams_[i];
    if (beam.born_s + kLife_s < time_s) continue;
    if (anchor && beam.entity == anchor->entity) beam.start_world = anchor->origin_world;
    beams_[kept++] = beam;
    place_pieces(beam, time_s);
  }
  size_ = kept;
}

bool Beams::has_bolt(std::uint32_t entity) const {
  return std::any_of(
      beams_.begin(), beams_.begin() + static_cast<std::ptrdiff_t>(size_),
      [&](const Beam& beam) { return beam.entity == entity && beam.model != BeamModel::kBeam; });
}

// Places a piece every kPieceLength units from the start. The last one may reach past the end, as in stock
// Quake.
void Beams::place_pieces(const Beam& beam, double time_s) {
  const math::Vec3d start(beam.start_world), path = math::Vec3d(beam.end_world) - start;
  const double length = glm::length(path);
  if (length == 0) return;
  const double horizontal_length = std::hypot(path.x, path.y);
  const float pitch_deg = to_positive_degrees(std::atan2(path.z, horizontal_length));
  const float yaw_deg = horizontal_length > 0 ? to_positive_degrees(std::atan2(path.y, path.x)) : 0.0f;
  const double count = std::min(std::ceil(length / double{kPieceLength}), double{kMaxPieces});
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(count); ++i) {
    const math::Vec3d place = start + path * (i * double{kPieceLength} / length);
    pieces_.push_back(
        {beam.model, math::Vec3(place), {pitch_deg, yaw_deg, compute_roll_deg(beam, i, time_s)}});
  }
}

}  // namespace temblor::client
