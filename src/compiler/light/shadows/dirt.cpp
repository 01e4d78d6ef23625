// Method: kDirtRays rays for each place, spread evenly over a cap around its normal. Each counts by how far
// it gets, so near walls darken more than distant ones.
#include "compiler/light/shadows/dirt.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "compiler/light/sources/directions.h"

namespace temblor::compiler {
namespace {

constexpr int kDirtRays = 48;

}  // namespace

std::vector<float> compute_dirt(const RayScene& scene, std::span<const math::Vec3> places,
                                std::span<const math::Vec3> normals, const DirtSettings& settings) {
  CHECK(places.size() == normals.size());
  std::vector<Frame> frames;
  frames.reserve(normals.size());
  for (const math::Vec3& normal : normals) frames.push_back(frame_around(normal));
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
  std::vector<float> left;
  left.reserve(places.size());
  for (const float sum : open) {
    const float occluded = std::max(0.0f, 1 - sum / (static_cast<float>(kDirtRays) * settings.depth));
    left.push_back(1 - std::min(1.0f, settings.scale * std::min(1.0f, std::pow(occluded, settings.gain))));
  }
  return left;
}

}  // namespace temblor::compiler
