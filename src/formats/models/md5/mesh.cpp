// NAME.md5mesh: the skeleton and the meshes.
#include <fmt/format.h>

#include "formats/models/md5.h"
#include "formats/models/md5/joints.h"
#include "formats/models/md5/scanner.h"

namespace temblor::formats {
namespace {

void read_joints(Md5Scanner& io_scanner, std::size_t count, Md5Model& out_model) {
  io_scanner.expect("{");
  for (std::size_t number = 0; number < count && io_scanner.ok(); ++number) {
    out_model.joints.push_back(read_md5_joint(io_scanner, number));
    const math::Vec3 position = io_scanner.vec3(), orientation = io_scanner.vec3();
    out_model.bind_pose.push_back({position, complete_orientation(orientation)});
  }
  io_scanner.expect("}");
}

void read_vertices(Md5Scanner& io_scanner, Md5Mesh& out_mesh) {
  io_scanner.expect("numverts");
  const std::uint32_t count = io_scanner.count(kMaxMd5Vertices);
  for (std::size_t number = 0; number < count && io_scanner.ok(); ++number) {
    io_scanner.expect_element("vert", number);
    Md5Vertex vertex;
    vertex.texel = io_scanner.vec2();
    vertex.first_weight = io_scanner.count(kMaxMd5Weights);
    vertex.weight_count = io_scanner.count(kMaxMd5Weights);
    out_mesh.vertices.push_back(vertex);
  }
}

void read_triangles(Md5Scanner& io_scanner, Md5Mesh& out_mesh) {
  io_scanner.expect("numtris");
  const std::uint32_t count = io_scanner.count(kMaxMd5Triangles);
  const auto last = static_cast<std::int32_t>(out_mesh.vertices.size()) - 1;
  for (std::size_t number = 0; number < count && io_scanner.ok(); ++number) {
    io_scanner.expect_element("tri", number);
    std::array<std::uint32_t, 3> triangle{};
    for (std::uint32_t& vertex : triangle)
      vertex = static_cast<std::uint32_t>(io_scanner.whole_number(0, last));
    out_mesh.triangles.push_back(triangle);
  }
}

void read_weights(Md5Scanner& io_scanner, std::size_t joint_count, Md5Mesh& out_mesh) {
  io_scanner.expect("numweights");
  const std::uint32_t count = io_scanner.count(kMaxMd5Weights);
  const auto last_joint = static_cast<std::int32_t>(joint_count) - 1;
  for (std::size_t number = 0; number < count && io_scanner.ok(); ++number) {
    io_scanner.expect_element("weight", number);
    Md5Weight weight;
    weight.joint = static_cast<std::uint32_t>(io_scanner.whole_number(0, last_joint));
    weight.bias = io_scanner.number();
    weight.position = io_scanner.vec3();
    out_mesh.weights.push_back(weight);
  }
}

// The second rule bounds the time that skinning takes by the size of the file.
void check_weights(Md5Scanner& io_scanner, const Md5Mesh& mesh) {
  std::size_t used = 0;
  for (std::size_t number = 0; number < mesh.vertices.size(); ++number) {
    const Md5Vertex& vertex = mesh.vertices[number];
    if (std::size_t{vertex.first_weight} + vertex.weight_count > mesh.weights.size())
      io_scanner.fail(fmt::format("vertex {} has weights {} to {}, but the mesh has {}", number,
                                  vertex.first_weight, vertex.first_weight + vertex.weight_count,
                                  mesh.weights.size()));
    used += vertex.weight_count;
  }
  if (used > mesh.weights.size())
    io_scanner.fail(
        fmt::format("the vertices have {} weights together, but the mesh has {}", used, mesh.weights.size()));
}

Md5Mesh read_mesh(Md5Scanner& io_scanner, std::size_t joint_count) {
  Md5Mesh mesh;
  io_scanner.expect("{");
  if (io_scanner.accept("shader")) mesh.shader = io_scanner.word();
  read_vertices(io_scanner, mesh);
  read_triangles(io_scanner, mesh);
  read_weights(io_scanner, joint_count, mesh);
  io_scanner.expect("}");
  check_weights(io_scanner, mesh);
  return mesh;
}

}  // namespace

base::Result<Md5Model> read_md5_model(std::string_view text) {
  Md5Scanner scanner(text);
  read_md5_header(scanner);
  scanner.expect("numJoints");
  const std::uint32_t joint_count = scanner.count(kMaxMd5Joints);
  scanner.expect("numMeshes");
  const auto mesh_count = scanner.whole_number(1, kMaxMd5Meshes);
  scanner.expect("joints");
  Md5Model model;
  read_joints(scanner, joint_count, model);
  for (std::int32_t number = 0; number < mesh_count && scanner.ok(); ++number) {
    scanner.expect("mesh");
    model.meshes.push_back(read_mesh(scanner, joint_count));
  }
  if (!scanner.ok()) return scanner.error();
  return model;
}

std::vector<math::Vec3> skin_vertices(const Md5Mesh& mesh, std::span<const Md5JointPose> pose) {
  std::vector<math::Vec3> positions;
  positions.reserve(mesh.vertices.size());
  for (const Md5Vertex& vertex : mesh.vertices) {
    math::Vec3 position{0.0f};
    for (const Md5Weight& weight :
         std::span(mesh.weights).subspan(vertex.first_weight, vertex.weight_count)) {
      const Md5JointPose& joint = pose[weight.joint];
      position += weight.bias * (joint.position + joint.orientation * weight.position);
    }
    positions.push_back(position);
  }
  return positions;
}

}  // namespace temblor::formats
