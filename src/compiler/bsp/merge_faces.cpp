#include <algorithm>
#include <numeric>
#include <optional>
#include <tuple>

#include "compiler/bsp/faces.h"

namespace temblor::compiler {
namespace {

bool same(const math::Vec3d& a, const math::Vec3d& b) {
  return glm::all(glm::lessThan(glm::abs(a - b), math::Vec3d(kOnPlane)));
}

// How a corner turns where two windings meet: the second's next point, seen along the first's last side.
enum class Turn { kInwards, kStraight, kOutwards };
Turn turn_at(const math::Vec3d& from, const math::Vec3d& corner, const math::Vec3d& to,
             const math::Vec3d& normal) {
  const math::Vec3d outwards = glm::normalize(glm::cross(normal, corner - from));
  const double away = glm::dot(to - corner, outwards);
  return away > kOnPlane ? Turn::kOutwards : away < -kOnPlane ? Turn::kInwards : Turn::kStraight;
}

std::optional<Winding> join(const Winding& a, const Winding& b, const math::Vec3d& normal) {
  const std::size_t a_count = a.size(), b_count = b.size();
  for (std::size_t i = 0; i < a_count; ++i)
    for (std::size_t j = 0; j < b_count; ++j) {
      const math::Vec3d &a_begin = a[i], &a_end = a[(i + 1) % a_count];
      if (!same(a_begin, b[(j + 1) % b_count]) || !same(a_end, b[j])) continue;
      const Turn at_begin = turn_at(a[(i + a_count - 1) % a_count], a_begin, b[(j + 2) % b_count], normal);
      const Turn at_end = turn_at(b[(j + b_count - 1) % b_count], a_end, a[(i + 2) % a_count], normal);
      if (at_begin == Turn::kOutwards || at_end == Turn::kOutwards) return std::nullopt;
      Winding joined;
      // All of the first from the common side's end to its begin, then the second's rest.
      for (std::size_t k = at_end == Turn::kStraight ? 2 : 1; k < a_count; ++k)
        joined.push_back(a[(i + k) % a_count]);
      if (at_begin != Turn::kStraight) joined.push_back(a_begin);
      for (std::size_t k = 2; k < b_count; ++k) joined.push_back(b[(j + k) % b_count]);
      return joined;
    }
  return std::nullopt;
}

auto group_of(const TreeFace& face) {
  return std::tuple(face.node, face.plane, face.surface);
}

// Joins what can be joined among faces [begin, end); emptied ones have no winding left.
void merge_group(std::span<TreeFace> faces, const math::Vec3d& normal) {
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (faces[i].winding.empty()) continue;
    for (std::size_t j = 0; j < faces.size(); ++j) {
      if (j == i || faces[j].winding.empty()) continue;
      std::optional<Winding> joined = join(faces[i].winding, faces[j].winding, normal);
      if (!joined) continue;
      faces[i].winding = std::move(*joined);
      faces[i].leafs.insert(faces[i].leafs.end(), faces[j].leafs.begin(), faces[j].leafs.end());
      faces[j].winding.clear();
      j = static_cast<std::size_t>(-1);  // what did not fit before may fit now
    }
  }
}

}  // namespace

void merge_faces(std::vector<TreeFace>& io_faces, const PlaneSet& planes) {
  std::stable_sort(io_faces.begin(), io_faces.end(),
                   [](const TreeFace& a, const TreeFace& b) { return group_of(a) < group_of(b); });
  for (std::size_t begin = 0, end; begin < io_faces.size(); begin = end) {
    for (end = begin + 1; end < io_faces.size() && group_of(io_faces[end]) == group_of(io_faces[begin]);)
      ++end;
    merge_group(std::span(io_faces).subspan(begin, end - begin), planes[io_faces[begin].plane].normal);
  }
  std::erase_if(io_faces, [](const TreeFace& face) { return face.winding.empty(); });
  for (TreeFace& face : io_faces) {
    std::sort(face.leafs.begin(), face.leafs.end());
    face.leafs.erase(std::unique(face.leafs.begin(), face.leafs.end()), face.leafs.end());
  }
}

}  // namespace temblor::compiler
