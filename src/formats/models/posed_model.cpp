#include "formats/models/posed_model.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <tuple>

#include "formats/models/mdl_normals.h"

namespace temblor::formats {
namespace {

// By vertex: the first vertex at the same place in the bind pose. Meshes have several vertices at the seams
// of their skins, which share a normal.
std::vector<std::uint32_t> find_twins(const std::vector<math::Vec3>& positions) {
  std::map<std::tuple<float, float, float>, std::uint32_t> first_at;
  std::vector<std::uint32_t> twins;
  for (std::uint32_t i = 0; i < positions.size(); ++i) {
    const math::Vec3& p = positions[i];
    twins.push_back(first_at.try_emplace({p.x, p.y, p.z}, i).first->second);
  }
  return twins;
}

// Appends the normals of one pose: the means of the triangles around each vertex, weighted by their areas.
void append_normals(const std::vector<math::Vec3>& positions, const std::vector<std::uint32_t>& twins,
                    PosedMesh& io_mesh) {
  std::vector<math::Vec3> sums(positions.size(), math::Vec3(0.0f));
  for (const auto& [a, b, c] : io_mesh.triangles) {
    const math::Vec3 area = glm::cross(positions[c] - positions[a], positions[b] - positions[a]);
    for (const std::uint32_t corner : {a, b, c}) sums[twins[corner]] += area;
  }
  for (const std::uint32_t twin : twins) io_mesh.normals.push_back(find_nearest_normal(sums[twin]));
}

math::Vec3 decode_normal(const Md3Vertex& vertex) {
  constexpr float kTurn = 2 * std::numbers::pi_v<float> / 256;
  const float zenith = static_cast<float>(vertex.zenith) * kTurn;
  const float azimuth = static_cast<float>(vertex.azimuth) * kTurn;
  return {std::cos(azimuth) * std::sin(zenith), std::sin(azimuth) * std::sin(zenith), std::cos(zenith)};
}

// By zenith and azimuth, so that the search runs once for each normal that files can have.
std::vector<std::uint8_t> make_md3_normals() {
  std::vector<std::uint8_t> normals;
  for (unsigned zenith = 0; zenith < 256; ++zenith)
    for (unsigned azimuth = 0; azimuth < 256; ++azimuth)
      normals.push_back(find_nearest_normal(
          decode_normal({{}, static_cast<std::uint8_t>(zenith), static_cast<std::uint8_t>(azimuth)})));
  return normals;
}

base::Status check_size(std::size_t vertices, std::size_t poses) {
  if (vertices == 0) return base::malformed("the model has no vertices");
  if (vertices > kMaxPosedVertices / poses)
    return base::error(base::ErrorCode::kTooLarge, "{} vertices in {} frames are too many; the limit is {}",
                       vertices, poses, kMaxPosedVertices);
  return base::Ok{};
}

// The renderer stores positions as multiples of a step, which must stay finite and exact.
base::Status check_reach(const PosedModel& model) {
  const math::Bounds bounds = compute_bounds(model);
  const math::Vec3 reach = glm::max(glm::abs(bounds.mins), glm::abs(bounds.maxs));
  // Also false for numbers that are not finite.
  if (reach.x <= kMaxMdlCoordinate && reach.y <= kMaxMdlCoordinate && reach.z <= kMaxMdlCoordinate)
    return base::Ok{};
  return base::error(base::ErrorCode::kTooLarge, "vertices are more than {} units away", kMaxMdlCoordinate);
}

void add_single_frames(PosedModel& io_model) {
  for (std::uint32_t pose = 0; pose < io_model.pose_count; ++pose) io_model.frames.push_back({pose, 1, {}});
}

PosedMesh pose_md5_mesh(const Md5Mesh& mesh, const Md5Model& model, const Md5Animation& animation) {
  PosedMesh posed;
  posed.skins.push_back(mesh.shader);
  posed.triangles = mesh.triangles;
  for (const Md5Vertex& vertex : mesh.vertices) posed.texels.push_back(vertex.texel);
  const std::vector<std::uint32_t> twins = find_twins(skin_vertices(mesh, model.bind_pose));
  for (const std::vector<Md5JointPose>& pose : animation.poses) {
    const std::vector<math::Vec3> positions = skin_vertices(mesh, pose);
    posed.positions.insert(posed.positions.end(), positions.begin(), positions.end());
    append_normals(positions, twins, posed);
  }
  return posed;
}

PosedMesh pose_md3_surface(const Md3Surface& surface) {
  static const std::vector<std::uint8_t> normals = make_md3_normals();
  PosedMesh posed;
  posed.skins = surface.shaders;
  posed.triangles = surface.triangles;
  posed.texels = surface.texels;
  for (const Md3Vertex& vertex : surface.vertices) {
    posed.positions.push_back(math::Vec3(vertex.position[0], vertex.position[1], vertex.position[2]) *
                              kMd3Units);
    posed.normals.push_back(normals[std::size_t{vertex.zenith} * 256 + vertex.azimuth]);
  }
  return posed;
}

}  // namespace

base::Result<PosedModel> pose_md5(const Md5Model& model, const Md5Animation& animation) {
  TRY_STATUS(check_same_skeleton(model, animation));
  std::size_t vertices = 0;
  for (const Md5Mesh& mesh : model.meshes) vertices += mesh.vertices.size();
  TRY_STATUS(check_size(vertices, animation.poses.size()));
  PosedModel posed;
  posed.pose_count = animation.poses.size();
  for (const Md5Mesh& mesh : model.meshes) posed.meshes.push_back(pose_md5_mesh(mesh, model, animation));
  add_single_frames(posed);
  TRY_STATUS(check_reach(posed));
  return posed;
}

base::Result<PosedModel> pose_md3(const Md3& md3) {
  PosedModel posed;
  posed.pose_count = md3.frames.size();
  posed.flags = md3.flags;
  for (const Md3Surface& surface : md3.surfaces) posed.meshes.push_back(pose_md3_surface(surface));
  add_single_frames(posed);
  return posed;
}

void take_frames(const Mdl& mdl, PosedModel& io_model) {
  io_model.flags = mdl.flags;
  io_model.random_phase = mdl.random_phase;
  io_model.frames.clear();
  const auto last = static_cast<std::uint32_t>(io_model.pose_count - 1);
  std::uint32_t next = 0;
  for (const MdlFrame& frame : mdl.frames) {
    const auto count = static_cast<std::uint32_t>(frame.poses.size());
    const std::uint32_t first = std::min(next, last);
    io_model.frames.push_back({first, std::min(count, last - first + 1), frame.end_times_s});
    next += count;
  }
}

math::Bounds compute_bounds(const PosedModel& model) {
  constexpr float kFar = std::numeric_limits<float>::infinity();
  math::Bounds bounds{math::Vec3(kFar), math::Vec3(-kFar)};
  for (const PosedMesh& mesh : model.meshes)
    for (const math::Vec3& position : mesh.positions) {
      bounds.mins = glm::min(bounds.mins, position);
      bounds.maxs = glm::max(bounds.maxs, position);
    }
  return bounds;
}

}  // namespace temblor::formats
