// MD5 models (.md5mesh) and their animations (.md5anim).
#include <nlohmann/json.hpp>

#include "app/inspect/inspection.h"
#include "base/text.h"
#include "formats/models/md5.h"

namespace temblor::app {
namespace {

Inspection list_joints(const std::vector<formats::Md5Joint>& joints) {
  Inspection list = Inspection::array();
  for (const formats::Md5Joint& joint : joints)
    list.push_back({{"name", base::printable(joint.name)}, {"parent", joint.parent}});
  return list;
}

}  // namespace

base::Result<Inspection> inspect_md5_model(base::Bytes bytes) {
  TRY(const formats::Md5Model model, formats::read_md5_model(base::as_text(bytes)));
  Inspection meshes = Inspection::array(), problems = Inspection::array();
  for (const formats::Md5Mesh& mesh : model.meshes) {
    Inspection entry{{"shader", base::printable(mesh.shader)},
                     {"vertices", mesh.vertices.size()},
                     {"triangles", mesh.triangles.size()},
                     {"weights", mesh.weights.size()}};
    const std::vector<math::Vec3> positions = formats::skin_vertices(mesh, model.bind_pose);
    if (!positions.empty()) {
      math::Vec3 mins = positions[0], maxs = positions[0];
      for (const math::Vec3& position : positions) {
        mins = glm::min(mins, position);
        maxs = glm::max(maxs, position);
      }
      entry["mins"] = make_json(mins);
      entry["maxs"] = make_json(maxs);
    }
    if (mesh.triangles.empty()) problems.push_back("a mesh has no triangles");
    meshes.push_back(std::move(entry));
  }
  return Inspection{{"meshes", meshes}, {"joints", list_joints(model.joints)}, {"problems", problems}};
}

base::Result<Inspection> inspect_md5_animation(base::Bytes bytes) {
  TRY(const formats::Md5Animation animation, formats::read_md5_animation(base::as_text(bytes)));
  return Inspection{{"frames per second", animation.frames_per_second},
                    {"counts", {{"frames", animation.poses.size()}, {"joints", animation.joints.size()}}},
                    {"joints", list_joints(animation.joints)},
                    {"problems", Inspection::array()}};
}

}  // namespace temblor::app
