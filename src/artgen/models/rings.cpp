#include "artgen/models/rings.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace temblor::artgen {
namespace {

using math::Vec3d;

// How far a round end extends beyond its ring, in radii.
constexpr double kRoundEnd = 0.5;

bool is_point(const Ring& ring) {
  return ring.width <= 0 && ring.depth <= 0;
}

// The frame of a ring: along the line, and the two axes of the ellipse.
struct RingAxes {
  Vec3d along, side, other;
};

// Builds one surface; works on a copy of the rings.
class RingBuilder {
 public:
  RingBuilder(const RingSurface& surface, std::uint32_t shape, Mesh& io_mesh)
      : rings_(surface.rings), surface_(surface), shape_(shape), mesh_(io_mesh) {}

  void build() {
    flat_first_ = !is_point(rings_.front()) && surface_.first_end == RingEnd::kFlat;
    flat_last_ = !is_point(rings_.back()) && surface_.last_end == RingEnd::kFlat;
    find_axes();
    add_round_ends();
    // Round ends add rings, so the axes are computed again.
    find_axes();
    add_points();
    add_sides();
    if (flat_first_) add_cap(0, !is_clockwise_);
    if (flat_last_) add_cap(rings_.size() - 1, is_clockwise_);
  }

 private:
  // Finds the rings' frames. The side axis is carried from ring to ring (parallel transport), so that the
  // surface does not twist. is_clockwise_ records whether angles run the other way, which reverses all
  // triangles.
  void find_axes() {
    axes_.assign(rings_.size(), {});
    for (std::size_t i = 0; i < rings_.size(); ++i) {
      const Vec3d before = rings_[i > 0 ? i - 1 : 0].center;
      const Vec3d after = rings_[std::min(i + 1, rings_.size() - 1)].center;
      const Vec3d direction = after - before;
      axes_[i].along = glm::length(direction) > 1e-9 ? glm::normalize(direction) : Vec3d(0, 0, 1);
    }
    const Vec3d whole = rings_.back().center - rings_.front().center;
    const Vec3d size = glm::abs(whole);
    const bool is_sideways = size.y > std::max(size.x, size.z);
    const bool is_forward = !is_sideways && size.x > size.z;
    Vec3d side = is_sideways ? Vec3d(1, 0, 0) : Vec3d(0, 1, 0);
    const Vec3d other = is_sideways || is_forward ? Vec3d(0, 0, 1) : Vec3d(1, 0, 0);
    is_clockwise_ = glm::dot(glm::cross(side, whole), other) < 0;
    for (RingAxes& ring : axes_) {
      side = side - ring.along * glm::dot(side, ring.along);
      side = glm::length(side) > 1e-6
                 ? glm::normalize(side)
                 : glm::normalize(glm::cross(ring.along, Vec3d(ring.along.y, ring.along.z, ring.along.x)));
      ring.side = side;
      ring.other = glm::cross(side, ring.along) * (is_clockwise_ ? -1.0 : 1.0);
    }
  }

  // A round end is one more ring, a point beyond the last one.
  void add_round_ends() {
    const auto pole = [&](std::size_t from, double direction) {
      Ring ring = rings_[from];
      ring.center += axes_[from].along * (direction * kRoundEnd * 0.5 * (ring.width + ring.depth));
      ring.width = ring.depth = 0;
      return ring;
    };
    if (!is_point(rings_.back()) && !flat_last_) rings_.push_back(pole(rings_.size() - 1, 1));
    if (!is_point(rings_.front()) && !flat_first_) rings_.insert(rings_.begin(), pole(0, -1));
  }

  double angle_deg(std::size_t corner) const {
    return -180 + surface_.turn_deg + 360 * static_cast<double>(corner) / sides();
  }
  double sides() const { return static_cast<double>(surface_.sides); }

  // The position of a corner on its ring.
  Vec3d ring_position(std::size_t ring, std::size_t corner) const {
    const double angle = angle_deg(corner) * (std::numbers::pi / 180);
    return rings_[ring].center + axes_[ring].side * (rings_[ring].width * std::sin(angle)) +
           axes_[ring].other * (rings_[ring].depth * std::cos(angle));
  }

  // Adds the points ring by ring, and measures lengths for the chart: the average distance between rings, and
  // each ring's circumference.
  void add_points() {
    const auto sides_count = static_cast<std::size_t>(surface_.sides);
    double length = 0;
    for (std::size_t i = 0; i < rings_.size(); ++i) {
      const Ring& ring = rings_[i];
      first_points_.push_back(static_cast<std::uint32_t>(mesh_.points.size()));
      const std::size_t count = is_point(ring) ? 1 : sides_count;
      for (std::size_t j = 0; j < count; ++j)
        mesh_.points.push_back({ring_position(i, j), ring.bone_a, ring.bone_b, ring.share_b});
      double step = 0, round = 0;
      for (std::size_t j = 0; j < sides_count; ++j) {
        if (i > 0) step += glm::distance(ring_position(i, j), ring_position(i - 1, j)) / sides();
        round += glm::distance(ring_position(i, j), ring_position(i, j + 1));
      }
      length += step;
      lengths_.push_back(length);
      rounds_.push_back(round);
    }
  }

  // A corner of the side surface. A point ring has one point but a chart position for each side: in the
  // middle of the side if `middle` is set.
  MeshCorner corner(std::size_t ring, std::size_t side_corner, bool middle, double round) const {
    const double at = static_cast<double>(side_corner) + (middle ? 0.5 : 0.0);
    const bool point = is_point(rings_[ring]);
    MeshCorner made;
    made.point =
        first_points_[ring] +
        (point ? 0 : static_cast<std::uint32_t>(side_corner % static_cast<std::size_t>(surface_.sides)));
    made.position = {(at / sides() - 0.5) * round, lengths_[ring]};
    made.along = lengths_.back() > 0 ? lengths_[ring] / lengths_.back() : 0;
    made.around_deg = -180 + surface_.turn_deg + 360 * at / sides();
    return made;
  }

  void add_triangle(const MeshCorner& a, const MeshCorner& b, const MeshCorner& c, bool turned) {
    MeshTriangle triangle;
    triangle.corners = turned ? std::array{a, c, b} : std::array{a, b, c};
    triangle.chart = static_cast<std::uint32_t>(mesh_.chart_shapes.size() - 1);
    triangle.smooth = mesh_.smooth_count - 1;
    mesh_.triangles.push_back(triangle);
    mesh_.is_image.push_back(false);
  }

  // Each quad starts a smoothing group of its own, or shares one with its ring or with the whole surface.
  void add_sides() {
    mesh_.chart_shapes.push_back(shape_);
    if (surface_.edges == Edges::kSmooth) ++mesh_.smooth_count;
    for (std::size_t i = 0; i + 1 < rings_.size(); ++i) {
      if (surface_.edges == Edges::kRings) ++mesh_.smooth_count;
      const bool low_point = is_point(rings_[i]), high_point = is_point(rings_[i + 1]);
      for (std::size_t j = 0; j < static_cast<std::size_t>(surface_.sides); ++j) {
        if (surface_.edges == Edges::kHard) ++mesh_.smooth_count;
        const double low = rounds_[low_point ? i + 1 : i], high = rounds_[high_point ? i : i + 1];
        const MeshCorner a = corner(i, j, low_point, low), b = corner(i, j + 1, low_point, low);
        const MeshCorner c = corner(i + 1, j + 1, high_point, high), d = corner(i + 1, j, high_point, high);
        if (!low_point) add_triangle(a, b, c, is_clockwise_);
        if (!high_point) add_triangle(a, c, d, is_clockwise_);
      }
    }
  }

  // A fan of triangles around corner 0.
  void add_cap(std::size_t ring, bool turned) {
    mesh_.chart_shapes.push_back(shape_);
    ++mesh_.smooth_count;
    const auto cap_corner = [&](std::size_t j) {
      MeshCorner made = corner(ring, j, false, 0);
      const double angle = angle_deg(j) * (std::numbers::pi / 180);
      made.position = {rings_[ring].width * std::sin(angle), rings_[ring].depth * std::cos(angle)};
      return made;
    };
    for (std::size_t j = 1; j + 1 < static_cast<std::size_t>(surface_.sides); ++j)
      add_triangle(cap_corner(0), cap_corner(j), cap_corner(j + 1), turned);
  }

  std::vector<Ring> rings_;
  const RingSurface& surface_;
  std::uint32_t shape_;
  Mesh& mesh_;
  bool flat_first_ = false, flat_last_ = false;
  // Angles run clockwise along the line.
  bool is_clockwise_ = false;
  std::vector<RingAxes> axes_;
  std::vector<std::uint32_t> first_points_;
  // For each ring: the distance from the first ring, and the circumference.
  std::vector<double> lengths_, rounds_;
};

}  // namespace

void add_rings(const RingSurface& surface, std::uint32_t shape, Mesh& io_mesh) {
  RingBuilder(surface, shape, io_mesh).build();
}

}  // namespace temblor::artgen
