#include "compiler/light/faces/face_normals.h"

#include <array>
#include <map>

#include "base/hash.h"
#include "compiler/light/faces/face_frame.h"
#include "compiler/light/faces/phong.h"
#include "world/face_at.h"

namespace temblor::compiler {
namespace {

// Gives equal vectors one number.
class VectorTable {
 public:
  std::uint32_t add(const math::Vec3d& vector) {
    const math::Vec3 rounded(vector);
    const std::array<std::uint64_t, 3> key = {base::float_bits(rounded.x), base::float_bits(rounded.y),
                                              base::float_bits(rounded.z)};
    const auto [place, is_new] = numbers_.try_emplace(key, static_cast<std::uint32_t>(vectors_.size()));
    if (is_new) vectors_.push_back(rounded);
    return place->second;
  }
  std::vector<math::Vec3> take() && { return std::move(vectors_); }

 private:
  std::map<std::array<std::uint64_t, 3>, std::uint32_t> numbers_;
  std::vector<math::Vec3> vectors_;
};

}  // namespace

formats::FaceNormals make_face_normals(const LitLevel& lit) {
  const world::Level& level = *lit.level;
  const PhongNormals phong(lit);
  VectorTable table;
  formats::FaceNormals normals;
  for (std::size_t number = 0; number < level.faces.size(); ++number) {
    const world::Face& face = level.faces[number];
    const world::TextureAxes& axes = level.texture_axes[face.axes];
    const math::Vec3d flat(world::compute_face_plane(level, face).normal);
    const std::span<const math::Vec3d> curved = phong.corners(number);
    for (std::size_t i = 0; i < face.surfedge_count; ++i) {
      const FaceFrame frame = make_face_frame(axes, curved.empty() ? flat : curved[i]);
      // The order of these calls decides about the numbers, so it must not be left to the compiler.
      const std::uint32_t normal = table.add(frame.normal), tangent = table.add(frame.tangent);
      normals.corners.push_back({normal, tangent, table.add(frame.bitangent)});
    }
  }
  normals.vectors = std::move(table).take();
  return normals;
}

}  // namespace temblor::compiler
