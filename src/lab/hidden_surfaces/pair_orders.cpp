#include "lab/hidden_surfaces/pair_orders.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace temblor::lab {

namespace {

// Units. Corners are rounded to float and may lie beside their plane.
constexpr double kOnPlane = 1.0 / 32;

enum class Side { kFront, kBack, kOn, kBoth };

// Where the corners of `face` are, seen from the front of the plane of `other`.
Side find_side(const world::Level& level, const world::Face& face, const world::Face& other) {
  const world::Plane& plane = level.planes[other.plane];
  double lowest = std::numeric_limits<double>::max(), highest = -lowest;
  for (std::uint32_t i = 0; i < face.surfedge_count; ++i) {
    const math::Vec3d corner(level.vertices[level.surfedge_start(std::size_t{face.first_surfedge} + i)]);
    const double distance = world::distance_to(plane, corner);
    lowest = std::min(lowest, distance);
    highest = std::max(highest, distance);
  }
  if (other.back_side) lowest = -std::exchange(highest, -lowest);
  if (lowest < -kOnPlane) return highest > kOnPlane ? Side::kBoth : Side::kBack;
  return highest > kOnPlane ? Side::kFront : Side::kOn;
}

}  // namespace

PairOrder order_faces(const world::Level& level, world::FaceIndex first, world::FaceIndex second) {
  const Side second_side = find_side(level, level.face(second), level.face(first));
  const Side first_side = find_side(level, level.face(first), level.face(second));
  const bool is_first = second_side == Side::kBack || first_side == Side::kFront;
  const bool is_second = second_side == Side::kFront || first_side == Side::kBack;
  if (is_first == is_second) return PairOrder::kDepends;
  return is_first ? PairOrder::kFirst : PairOrder::kSecond;
}

PairOrders::PairOrders(std::size_t places)
    : places_(std::bit_ceil(std::max<std::size_t>(places, 2))),
      shift_(64 - std::countr_zero(places_.size())) {}

void PairOrders::use_level(const world::Level& level, bool keeps_pairs) {
  if (keeps_pairs && level_ == level.identity) return;
  level_ = level.identity;
  for (std::atomic<std::uint64_t>& place : places_) place.store(0, std::memory_order_relaxed);
}

bool CachedOrder::is_nearer(const BegunSurface& begun, render::SurfaceIndex other) {
  const render::ScreenSurface& surface = surfaces_[base::to_size(begun.surface)];
  const render::ScreenSurface& other_surface = surfaces_[base::to_size(other)];
  if (level_ == nullptr || surface.instance != other_surface.instance) return depths_.is_nearer(begun, other);
  const auto [first, second] = std::minmax(surface.face, other_surface.face);
  PairOrder order = pairs_->find(first, second);
  if (order == PairOrder::kUnknown) {
    order = order_faces(*level_, first, second);
    pairs_->store(first, second, order);
    ++misses_;
  } else if (order != PairOrder::kDepends) {
    ++hits_;
  }
  if (order == PairOrder::kDepends) return depths_.is_nearer(begun, other);
  return (order == PairOrder::kFirst) == (surface.face == first);
}

Counts CachedOrder::counts() const {
  Counts counts = depths_.counts();
  counts.comparisons += misses_;
  counts.cache_hits = hits_;
  return counts;
}

}  // namespace temblor::lab
