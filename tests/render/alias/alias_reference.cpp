#include "render/alias/alias_reference.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace temblor::test {

ReferencePicture reference_picture(const render::Camera& camera, int width, int height) {
  const double reference_width = std::min<double>(width, height * 4.0 / 3.0);
  return {width, height, reference_width / 2 / std::tan(camera.fov_deg * std::numbers::pi / 360),
          math::Vec3d(camera.origin_world), math::basis_from_angles(camera.angles_deg)};
}

ReferenceMesh reference_mesh(const formats::Mdl& mdl, std::size_t pose, const render::AliasInstance& instance,
                             const ReferencePicture& picture) {
  std::vector<const formats::MdlPose*> poses;
  for (const formats::MdlFrame& frame : mdl.frames)
    for (const formats::MdlPose& member : frame.poses) poses.push_back(&member);
  const math::Basis turn =
      math::basis_from_angles({-instance.angles_deg.x, instance.angles_deg.y, instance.angles_deg.z});
  ReferenceMesh mesh;
  for (const formats::MdlTriangle& triangle : mdl.triangles)
    for (const std::uint32_t vertex : triangle.vertices) {
      const auto& bytes = poses[pose]->vertices[vertex].position;
      const math::Vec3d model =
          (math::Vec3d(bytes[0], bytes[1], bytes[2]) * math::Vec3d(mdl.scale) + math::Vec3d(mdl.origin)) *
          double{instance.scale};
      const math::Vec3d world = math::Vec3d(instance.origin_world) + turn.forward * model.x -
                                turn.right * model.y + turn.up * model.z;
      const math::Vec3d d = world - picture.eye;
      const formats::MdlTexel& texel = mdl.texels[vertex];
      const bool shifted = texel.on_seam && !triangle.faces_front;
      mesh.corners.push_back(
          {{glm::dot(d, picture.axes.right), glm::dot(d, picture.axes.up), glm::dot(d, picture.axes.forward)},
           texel.s + 0.5 + (shifted ? mdl.skin_width / 2 : 0),
           texel.t + 0.5});
    }
  for (std::size_t i = 0; i < mesh.corners.size(); i += 3) {
    const ReferenceCorner* corner = &mesh.corners[i];
    mesh.normals.push_back(glm::cross(corner[2].view - corner[0].view, corner[1].view - corner[0].view));
  }
  return mesh;
}

ReferenceHit reference_hit(const ReferenceMesh& mesh, const ReferencePicture& picture, double x, double y,
                           double near_z) {
  const math::Vec3d ray{(x - (picture.width / 2.0 - 0.5)) / picture.focal_px,
                        -(y - (picture.height / 2.0 - 0.5)) / picture.focal_px, 1.0};
  ReferenceHit nearest;
  for (std::size_t triangle = 0; triangle * 3 < mesh.corners.size(); ++triangle) {
    const ReferenceCorner* corner = &mesh.corners[triangle * 3];
    const math::Vec3d& normal = mesh.normals[triangle];
    const double facing = glm::dot(normal, ray);
    // In view space x, y, z are left-handed, so that an outward normal of a front runs along the ray.
    if (facing <= 0) continue;
    const double z = glm::dot(normal, corner[0].view) / facing;
    if (!(z >= near_z) || (nearest.hit && 1 / z < nearest.depth)) continue;
    // Point = z * ray = a + u (b - a) + v (c - a).
    const math::Vec3d ab = corner[1].view - corner[0].view, ac = corner[2].view - corner[0].view;
    const math::Vec3d ap = ray * z - corner[0].view;
    const double scale = 1 / glm::dot(normal, normal);
    const double u = glm::dot(glm::cross(ac, ap), normal) * scale;
    const double v = glm::dot(glm::cross(ap, ab), normal) * scale;
    if (u < 0 || v < 0 || u + v > 1) continue;
    nearest = {true, 1 / z, corner[0].s + u * (corner[1].s - corner[0].s) + v * (corner[2].s - corner[0].s),
               corner[0].t + u * (corner[1].t - corner[0].t) + v * (corner[2].t - corner[0].t), triangle};
  }
  return nearest;
}

}  // namespace temblor::test
