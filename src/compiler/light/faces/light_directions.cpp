#include "compiler/light/faces/light_directions.h"

#include "compiler/light/faces/face_frame.h"
#include "formats/bspx/light_directions.h"
#include "world/face_at.h"

namespace temblor::compiler {

std::vector<std::uint8_t> pack_light_directions(const LitLevel& lit, std::size_t face,
                                                std::span<const math::Vec3> sums,
                                                std::span<const float> undirected) {
  const world::Level& level = *lit.level;
  const world::Face& shape = level.faces[face];
  const FaceFrame frame =
      make_face_frame(level.texture_axes[shape.axes], world::compute_face_plane(level, shape).normal);
  std::vector<std::uint8_t> packed;
  packed.reserve(sums.size() * 3);
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const math::Vec3d sum = math::Vec3d(sums[i]) + frame.normal * double{undirected[i]};
    const double length = glm::length(sum);
    const math::Vec3d toward = length > 0 ? sum / length : frame.normal;
    const math::Vec3 in_face(math::Vec3d(glm::dot(toward, frame.tangent), glm::dot(toward, frame.bitangent),
                                         glm::dot(toward, frame.normal)));
    for (const std::uint8_t byte : formats::pack_direction(in_face)) packed.push_back(byte);
  }
  return packed;
}

}  // namespace temblor::compiler
