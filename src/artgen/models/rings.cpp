#include "artgen/models/rings.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace temblor::artgen {
namespace {

using math::Vec3d;

constexpr double kRoundEnd = 0.5;  // how far a round end stands out, in radii

bool is_point(const Ring& ring) {
  return ring.width <= 0 && ring.depth <= 0;
}

struct RingAxes {
  Vec3d along, side, other;
};

class RingBuilder {
 public:
  RingBuilder(const RingSurface& surface, std::uint32_t shape, Mesh& io_mesh)
      : rings_(surface.rings), surface_(surface), shape_(shape), mesh_(io_mesh) {}

  void build() {
    flat_first_ = !is_point(rings_.front()) && surface_.first_end == RingEnd::kFlat;
    flat_last_ = !is_point(rings_.back()) && surface_.last_end == RingEnd::kFlat;
    find_axes();
    add_round_ends();
    find_axes();
    add_points();
    add_sides();
    if (flat_first_) add_cap(0, !turned_);
    if (flat_last_) add_cap(rings_.size() - 1, turned_);
  }

 private:
  // Directions along the line; the side axis is carried from ring to ring without twisting.
  void find_axes() {
    axes_.assign(rings_.size(), {});
    for (std::size_t i = 0; i < rings_.size(); ++i) {
      const Vec3d before = rings_[i > 0 ? i - 1 : 0].center;
      const Vec3d after = rings_[std::min(i + 1, rings_.size() - 1)].center;
      const Vec3d way = after - before;
      axes_[i].along = glm::length(way) > 1e-9 ? glm::normalize(way) : Vec3d(0, 0, 1);
    }
    const Vec3d whole = rings_.back().center - rings_.front().center;
    const Vec3d size = glm::abs(whole);
    const bool lies_across = size.y > std::max(size.x, size.z);
    const bool lies_ahead = !lies_across && size.x > size.z;
    Vec3d side = lies_across ? Vec3d(1, 0, 0) : Vec3d(0, 1, 0);
    const Vec3d other = lies_across || lies_ahead ? Vec3d(0, 0, 1) : Vec3d(1, 0, 0);
    turned_ = glm::dot(glm::cross(side, whole), other) < 0;
    for (RingAxes& ring : axes_) {
      side = side - ring.along * glm::dot(side, ring.along);
      side = glm::length(side) > 1e-6
                 ? glm::normalize(side)
                 : glm::normalize(glm::cross(ring.along, Vec3d(ring.along.y, ring.along.z, ring.along.x)));
      ring.side = side;
      ring.other = glm::cross(side, ring.along) * (turned_ ? -1.0 : 1.0);
    }
  }

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

  Vec3d place_on(std::size_t ring, std::size_t corner) const {
    const double angle = angle_deg(corner) * (std::numbers::pi / 180);
    return rings_[ring].center + axes_[ring].side * (rings_[ring].width * std::sin(angle)) +
           axes_[ring].other * (rings_[ring].depth * std::cos(angle));
  }

  void add_points() {
    const auto sides_count = static_cast<std::size_t>(surface_.sides);
    double length = 0;
    for (std::size_t i = 0; i < rings_.size(); ++i) {
      const Ring& ring = rings_[i];
      first_points_.push_back(static_cast<std::uint32_t>(mesh_.points.size()));
      const std::size_t count = is_point(ring) ? 1 : sides_count;
      for (std::size_t j = 0; j < count; ++j)
        mesh_.points.push_back({place_on(i, j), ring.bone_a, ring.bone_b, ring.share_b});
      double step = 0, round = 0;
      for (std::size_t j = 0; j < sides_count; ++j) {
        if (i > 0) step += glm::distance(place_on(i, j), place_on(i - 1, j)) / sides();
        round += glm::distance(place_on(i, j), place_on(i, j + 1));
      }
      length += step;
      lengths_.push_back(length);
      rounds_.push_back(round);
    }
  }

  // `middle`: of a side, for points.
  MeshCorner corner(std::size_t ring, std::size_t side_corner, bool middle, double round) const {
    const double at = static_cast<double>(side_corner) + (middle ? 0.5 : 0.0);
    const bool point = is_point(rings_[ring]);
    MeshCorner made;
    made.point =
        first_points_[ring] +
        (point ? 0 : static_cast<std::uint32_t>(side_corner % static_cast<std::size_t>(surface_.sides)));
    made.place = {(at / sides() - 0.5) * round, lengths_[ring]};
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
        if (!low_point) add_triangle(a, b, c, turned_);
        if (!high_point) add_triangle(a, c, d, turned_);
      }
    }
  }

  void add_cap(std::size_t ring, bool turned) {
    mesh_.chart_shapes.push_back(shape_);
    ++mesh_.smooth_count;
    const auto cap_corner = [&](std::size_t j) {
      MeshCorner made = corner(ring, j, false, 0);
      const double angle = angle_deg(j) * (std::numbers::pi / 180);
      made.place = {rings_[ring].width * std::sin(angle), rings_[ring].depth * std::cos(angle)};
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
  bool turned_ = false;  // angles run clockwise along the line
  std::vector<RingAxes> axes_;
  std::vector<std::uint32_t> first_points_;
  std::vector<double> lengths_, rounds_;  // by ring: from the first one; its circumference
};

}  // namespace

void add_rings(const RingSurface& surface, std::uint32_t shape, Mesh& io_mesh) {
  RingBuilder(surface, shape, io_mesh).build();
}

}  // namespace temblor::artgen
