// Method: faces are grouped by node, plane and surface. Within a group, a hash of all sides finds each face's
// neighbors, and faces are joined as long as the result is convex.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <tuple>
#include <unordered_map>

#include "compiler/bsp/faces/faces.h"

namespace temblor::compiler {
namespace {

// Whether two corners are the are_same point.
bool are_same(const math::Vec3d& a, const math::Vec3d& b) {
  return glm::all(glm::lessThan(glm::abs(a - b), math::Vec3d(kOnPlaneEpsilon)));
}

// How the outline turns at a corner where two windings meet. kOutward: the union is not convex there.
enum class Turn { kInward, kStraight, kOutward };
Turn find_turn(const math::Vec3d& from, const math::Vec3d& corner, const math::Vec3d& to,
               const math::Vec3d& normal) {
  const math::Vec3d outward = glm::normalize(glm::cross(normal, corner - from));
  const double away = glm::dot(to - corner, outward);
  return away > kOnPlaneEpsilon ? Turn::kOutward : away < -kOnPlaneEpsilon ? Turn::kInward : Turn::kStraight;
}

// Joins two windings along a common side; nothing if they have none or if the result is not convex. Corners
// that become straight are dropped.
std::optional<Winding> join(const Winding& a, const Winding& b, const math::Vec3d& normal) {
  const std::size_t a_count = a.size(), b_count = b.size();
  for (std::size_t i = 0; i < a_count; ++i)
    for (std::size_t j = 0; j < b_count; ++j) {
      const math::Vec3d &a_begin = a[i], &a_end = a[(i + 1) % a_count];
      if (!are_same(a_begin, b[(j + 1) % b_count]) || !are_same(a_end, b[j])) continue;
      const Turn at_begin = find_turn(a[(i + a_count - 1) % a_count], a_begin, b[(j + 2) % b_count], normal);
      const Turn at_end = find_turn(b[(j + b_count - 1) % b_count], a_end, a[(i + 2) % a_count], normal);
      if (at_begin == Turn::kOutward || at_end == Turn::kOutward) return std::nullopt;
      Winding joined;
      // The first winding from the end of the common side to its beginning, then the rest of the second.
      for (std::size_t k = at_end == Turn::kStraight ? 2 : 1; k < a_count; ++k)
        joined.push_back(a[(i + k) % a_count]);
      if (at_begin != Turn::kStraight) joined.push_back(a_begin);
      for (std::size_t k = 2; k < b_count; ++k) joined.push_back(b[(j + k) % b_count]);
      return joined;
    }
  return std::nullopt;
}

auto group_key(const TreeFace& face) {
  return std::tuple(face.node, face.plane, face.surface);
}

// A hash key for a side, from corner to corner, with rounded coordinates. Two faces whose common side falls
// on a rounding boundary may stay apart, which is harmless.
struct SideKey {
  std::array<std::int64_t, 6> corners;
  bool operator==(const SideKey&) const = default;
};
struct SideKeyHash {
  std::size_t operator()(const SideKey& key) const {
    std::uint64_t hash = 0;
    for (const std::int64_t part : key.corners)
      hash = (hash ^ static_cast<std::uint64_t>(part)) * 0x9e3779b97f4a7c15u;
    return static_cast<std::size_t>(hash ^ (hash >> 32));
  }
};
SideKey make_key(const math::Vec3d& from, const math::Vec3d& to) {
  constexpr double kStepsAUnit = 8;
  const auto step = [](double v) { return std::llround(v * kStepsAUnit); };
  return {{step(from.x), step(from.y), step(from.z), step(to.x), step(to.y), step(to.z)}};
}

// Joins the faces of one group; a face that was joined to another keeps no winding.
class GroupMerger {
 public:
  GroupMerger(std::span<TreeFace> faces, const math::Vec3d& normal) : faces_(faces), normal_(normal) {
    for (std::size_t i = 0; i < faces.size(); ++i) add_sides(i);
  }

  void merge() {
    for (std::size_t i = 0; i < faces_.size(); ++i)
      while (join_with_a_neighbor(i)) add_sides(i);
  }

 private:
  void add_sides(std::size_t face) {
    const Winding& winding = faces_[face].winding;
    for (std::size_t k = 0; k < winding.size(); ++k)
      by_side_.emplace(make_key(winding[k], winding[(k + 1) % winding.size()]), face);
  }

  // Joins face i with the first neighbor that fits. Returns false if there is none.
  bool join_with_a_neighbor(std::size_t i) {
    const Winding& winding = faces_[i].winding;
    for (std::size_t k = 0; k < winding.size(); ++k) {
      const auto [begin, end] = by_side_.equal_range(make_key(winding[(k + 1) % winding.size()], winding[k]));
      for (auto it = begin; it != end; ++it) {
        const std::size_t j = it->second;
        if (j == i || faces_[j].winding.empty()) continue;
        std::optional<Winding> joined = join(winding, faces_[j].winding, normal_);
        if (!joined) continue;
        faces_[i].winding = std::move(*joined);
        faces_[i].leaves.insert(faces_[i].leaves.end(), faces_[j].leaves.begin(), faces_[j].leaves.end());
        faces_[j].winding.clear();
        return true;
      }
    }
    return false;
  }

  std::span<TreeFace> faces_;
  const math::Vec3d normal_;
  // Sides that a face no longer has stay in the map: join() checks again.
  std::unordered_multimap<SideKey, std::size_t, SideKeyHash> by_side_;
};

}  // namespace

void merge_faces(std::vector<TreeFace>& io_faces, const PlaneSet& planes) {
  std::stable_sort(io_faces.begin(), io_faces.end(),
                   [](const TreeFace& a, const TreeFace& b) { return group_key(a) < group_key(b); });
  for (std::size_t begin = 0, end; begin < io_faces.size(); begin = end) {
    for (end = begin + 1; end < io_faces.size() && group_key(io_faces[end]) == group_key(io_faces[begin]);)
      ++end;
    GroupMerger(std::span(io_faces).subspan(begin, end - begin), planes[io_faces[begin].plane].normal)
        .merge();
  }
  std::erase_if(io_faces, [](const TreeFace& face) { return face.winding.empty(); });
  for (TreeFace& face : io_faces) {
    std::sort(face.leaves.begin(), face.leaves.end());
    face.leaves.erase(std::unique(face.leaves.begin(), face.leaves.end()), face.leaves.end());
  }
}

}  // namespace temblor::compiler
