// Method: kDirtRays rays for each place, spread evenly over a cap around its normal. Each counts by how far
// it gets, so near walls darken more than distant ones.
#include "compiler/light/shadows/dirt.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/hash.h"
#include "compiler/light/sources/directions.h"

namespace temblor::compiler {
namespace {

constexpr int kDirtRays = 48;

// The frame of a place, turned around its normal by an angle that only the place decides.
Frame turn_by_place(const Frame& frame, const math::Vec3& place) {
  std::uint64_t hash = 0;
  for (int axis = 0; axis < 3; ++axis)
    hash = base::hash_with(hash, static_cast<std::uint64_t>(std::lround(place[axis] * 8)));
  const double turn = static_cast<double>(hash >> 40) / (1 << 24) * 2 * std::numbers::pi;
  const auto cosine = static_cast<float>(std::cos(turn)), sine = static_cast<float>(std::sin(turn));
  return {frame.right * cosine + frame.forward * sine, frame.forward * cosine - frame.right * sine, frame.up};
}

}  // namespace

std::vector<float> compute_dirt(const RayScene& scene, std::span<const math::Vec3> places,
                                std::span<const math::Vec3> normals, const DirtSettings& settings) {
  CHECK(places.size() == normals.size());
  std::vector<Frame> frames;
  frames.reserve(normals.size());
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const Frame frame = frame_around(normals[i]);
    frames.push_back(settings.is_random ? turn_by_place(frame, places[i]) : frame);
  }
  const double cos_edge = std::cos(double{settings.angle_deg} * std::numbers::pi / 180);
  std::vector<float> open(places.size(), 0);
  std::vector<math::Vec3> directions(places.size());
  std::vector<RayHit> hits(places.size());
  // One direction for all places at a time, so that on a flat face the rays of a packet run side by side.
  for (int ray = 0; ray < kDirtRays; ++ray) {
    const math::Vec3 direction = cap_direction(ray, kDirtRays, cos_edge);
    for (std::size_t i = 0; i < places.size(); ++i) directions[i] = in_frame(frames[i], direction);
    scene.find_nearest(places, directions, settings.depth, hits);
    for (std::size_t i = 0; i < places.size(); ++i) open[i] += std::min(hits[i].distance, settings.depth);
  }
  std::vector<float> around;
  around.reserve(places.size());
  for (const float sum : open)
    around.push_back(std::max(0.0f, 1 - sum / (static_cast<float>(kDirtRays) * settings.depth)));
  return around;
}

float find_share_after_dirt(float around, float scale, float gain) {
  return 1 - std::min(1.0f, scale * std::min(1.0f, std::pow(around, gain)));
}

}  // namespace temblor::compiler
