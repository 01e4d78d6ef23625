// Feeds arbitrary text to the MD5 readers, as a model and as an animation. Each must return an error or a
// value that keeps the promises of its header: all indices in range, parents before children, finite
// positions. A model becomes a drawable one, in its bind pose.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/bytes.h"
#include "base/check.h"
#include "formats/models/md5.h"
#include "fuzz/targets.h"
#include "fuzz/targets/models/posed_checks.h"

namespace {

using namespace temblor::formats;

void check_joints(const std::vector<Md5Joint>& joints) {
  for (std::size_t number = 0; number < joints.size(); ++number)
    CHECK(joints[number].parent >= -1 && joints[number].parent < static_cast<std::int32_t>(number));
}

void check_finite(const Md5JointPose& pose) {
  CHECK(std::isfinite(glm::dot(pose.position, pose.position)));
  CHECK(std::abs(glm::length(pose.orientation) - 1) < 0.001f);
}

void check_mesh(const Md5Model& model, const Md5Mesh& mesh) {
  for (const auto& triangle : mesh.triangles)
    for (const std::uint32_t vertex : triangle) CHECK(vertex < mesh.vertices.size());
  for (const temblor::math::Vec3& position : skin_vertices(mesh, model.bind_pose))
    CHECK(std::isfinite(position.x) && std::isfinite(position.y) && std::isfinite(position.z));
}

}  // namespace

int temblor::fuzz::fuzz_md5(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = base::as_text(std::as_bytes(std::span(data, size)));
  if (const auto model = read_md5_model(text); model.ok()) {
    check_joints(model->joints);
    CHECK(model->bind_pose.size() == model->joints.size() && !model->meshes.empty());
    for (const Md5JointPose& pose : model->bind_pose) check_finite(pose);
    for (const Md5Mesh& mesh : model->meshes) check_mesh(*model, mesh);
    if (const auto posed = pose_md5(*model, {0, model->joints, {model->bind_pose}}); posed.ok())
      check_drawable(*posed);
  }
  if (const auto animation = read_md5_animation(text); animation.ok()) {
    check_joints(animation->joints);
    CHECK(!animation->poses.empty());
    for (const auto& pose : animation->poses) {
      CHECK(pose.size() == animation->joints.size());
      for (const Md5JointPose& joint : pose) check_finite(joint);
    }
  }
  return 0;
}
