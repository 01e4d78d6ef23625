// Turns a Model into the structures of an MDL file. Positions are stored as one byte per axis, relative to
// the bounds of all frames, and normals as indices into Quake's table of 162 directions.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

#include "artgen/models/model.h"
#include "formats/models/mdl_normals.h"

namespace temblor::artgen {
namespace {

using formats::Mdl;
using formats::MdlPose;
using formats::MdlVertex;
using math::Vec3d;

// Positions are bytes.
constexpr double kPoseByteSteps = 255;
// A frame's name has 16 bytes with a terminating zero.
constexpr std::size_t kMaxNameChars = 15;
// Units; larger models are an error in the script.
constexpr float kMaxRadius = 65536;

// A vertex of the file. A point becomes several vertices if it has several normals or texels.
struct FileVertex {
  std::uint32_t point = 0, smooth = 0;
};

struct FileMesh {
  std::vector<FileVertex> vertices;
  std::vector<formats::MdlTexel> texels;
  std::vector<formats::MdlTriangle> triangles;
};

// Merges corners with the same point, smoothing group, and texel.
FileMesh number_vertices(const Mesh& mesh, const Atlas& atlas) {
  FileMesh file;
  std::map<std::tuple<std::uint32_t, std::uint32_t, std::int32_t, std::int32_t>, std::uint32_t> known;
  for (const MeshTriangle& triangle : mesh.triangles) {
    formats::MdlTriangle made;
    for (std::size_t i = 0; i < 3; ++i) {
      const MeshCorner& corner = triangle.corners[i];
      const math::Vec2d texel = atlas.texel(triangle.chart, corner.position);
      const auto s = static_cast<std::int32_t>(texel.x), t = static_cast<std::int32_t>(texel.y);
      const auto next = static_cast<std::uint32_t>(file.vertices.size());
      const auto [entry, is_new] = known.try_emplace({corner.point, triangle.smooth, s, t}, next);
      if (is_new) {
        file.vertices.push_back({corner.point, triangle.smooth});
        file.texels.push_back({false, s, t});
      }
      made.vertices[2 - i] = entry->second;  // MDL triangles are clockwise
    }
    file.triangles.push_back(made);
  }
  return file;
}

// A frame before packing.
struct PosedModel {
  std::string name;
  // By point of the mesh.
  std::vector<Vec3d> positions;
};

// Poses one frame on top of the stance, settles it on the floor, and scales it.
PosedModel pose_model(const Model& model, const Animation& animation, std::int32_t frame) {
  const auto stance = model.poses.find("stance");
  const ChannelValues base = stance != model.poses.end() ? stance->second : ChannelValues{};
  const BonePose pose = pose_at(animation, model.skeleton, base, frame);
  PosedModel posed;
  posed.name = fmt::format("{}{}", animation.name, frame + 1).substr(0, kMaxNameChars);
  posed.positions = transform_points(model.mesh, rest_positions(model.skeleton),
                                     compute_bone_transforms(model.skeleton, pose));
  if (animation.settles) {
    double lowest = posed.positions.front().z;
    for (const Vec3d& position : posed.positions) lowest = std::min(lowest, position.z);
    for (Vec3d& position : posed.positions) position.z += model.floor - lowest;
  }
  const Vec3d middle(0, 0, model.floor);
  for (Vec3d& position : posed.positions) position = middle + (position - middle) * model.size;
  return posed;
}

// The index in Quake's table of normals.
std::uint8_t nearest_normal(const Vec3d& normal) {
  const auto all = formats::mdl_normals();
  std::size_t best = 0;
  for (std::size_t i = 1; i < all.size(); ++i)
    if (glm::dot(Vec3d(all[i]), normal) > glm::dot(Vec3d(all[best]), normal)) best = i;
  return static_cast<std::uint8_t>(best);
}

// Vertex normals by smoothing group and point, weighted by triangle area, not normalized.
std::map<std::pair<std::uint32_t, std::uint32_t>, Vec3d> sum_normals(const Mesh& mesh,
                                                                     const std::vector<Vec3d>& positions) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, Vec3d> sums;
  for (const MeshTriangle& triangle : mesh.triangles) {
    const auto& corners = triangle.corners;
    const Vec3d area = glm::cross(positions[corners[1].point] - positions[corners[0].point],
                                  positions[corners[2].point] - positions[corners[0].point]);
    for (const MeshCorner& corner : corners) sums[{triangle.smooth, corner.point}] += area;
  }
  return sums;
}

// Quantizes positions and normals, and computes the frame's bounds in bytes.
MdlPose pack(const PosedModel& posed, const Mesh& mesh, const FileMesh& file, const Mdl& mdl) {
  MdlPose pose;
  pose.name = posed.name;
  pose.mins.position = {255, 255, 255};
  const auto normals = sum_normals(mesh, posed.positions);
  for (const FileVertex& vertex : file.vertices) {
    MdlVertex made;
    const Vec3d steps = (posed.positions[vertex.point] - Vec3d(mdl.origin)) / Vec3d(mdl.scale);
    for (int axis = 0; axis < 3; ++axis) {
      const auto at = static_cast<std::size_t>(axis);
      made.position[at] = static_cast<std::uint8_t>(std::clamp(std::lround(steps[axis]), 0l, 255l));
      pose.mins.position[at] = std::min(pose.mins.position[at], made.position[at]);
      pose.maxs.position[at] = std::max(pose.maxs.position[at], made.position[at]);
    }
    const Vec3d normal = normals.at({vertex.smooth, vertex.point});
    made.normal = nearest_normal(glm::length(normal) > 1e-9 ? glm::normalize(normal) : Vec3d(0, 0, 1));
    pose.vertices.push_back(made);
  }
  return pose;
}

// Origin and scale are the same for all frames. The smallest scale avoids a division by zero for flat models.
void set_bounds(const std::vector<std::vector<PosedModel>>& animations, Mdl& out_mdl) {
  Vec3d low(1e9), high(-1e9);
  double radius = 0;
  for (const auto& shown_frames : animations)
    for (const PosedModel& posed : shown_frames)
      for (const Vec3d& position : posed.positions) {
        low = glm::min(low, position);
        high = glm::max(high, position);
        radius = std::max(radius, glm::length(position));
      }
  out_mdl.origin = math::Vec3(low);
  out_mdl.scale = math::Vec3(glm::max((high - low) / kPoseByteSteps, Vec3d(1e-4)));
  out_mdl.bounding_radius = static_cast<float>(radius);
}

// For the header's average triangle size.
double mean_area(const Mesh& mesh, const std::vector<Vec3d>& positions) {
  double sum = 0;
  for (const MeshTriangle& triangle : mesh.triangles)
    sum += 0.5 * glm::length(
                     glm::cross(positions[triangle.corners[1].point] - positions[triangle.corners[0].point],
                                positions[triangle.corners[2].point] - positions[triangle.corners[0].point]));
  return sum / static_cast<double>(mesh.triangles.size());
}

void merge_bounds(const MdlPose& pose, formats::MdlFrame& io_frame) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    io_frame.mins.position[axis] = std::min(io_frame.mins.position[axis], pose.mins.position[axis]);
    io_frame.maxs.position[axis] = std::max(io_frame.maxs.position[axis], pose.maxs.position[axis]);
  }
}

}  // namespace

Mdl make_mdl(const Model& model) {
  const Atlas atlas = lay_out_charts(model.mesh, model.density);
  const FileMesh file = number_vertices(model.mesh, atlas);
  Mdl mdl;
  mdl.eye = model.eye;
  mdl.flags = model.flags;
  mdl.random_phase = model.random_phase;
  mdl.texels = file.texels;
  mdl.triangles = file.triangles;
  mdl.skin_width = static_cast<std::uint32_t>(atlas.width);
  mdl.skin_height = static_cast<std::uint32_t>(atlas.height);
  const std::vector<SkinTexel> texels = find_skin_texels(model.mesh, atlas);
  for (const std::vector<Paint>& paints : model.skins)
    mdl.skins.push_back({{paint_skin(texels, atlas.width, model.shapes, paints)}, {}});

  std::vector<std::vector<PosedModel>> posed(model.animations.size());
  for (std::size_t i = 0; i < posed.size(); ++i)
    for (std::int32_t frame = 0; frame < model.animations[i].frames; ++frame)
      posed[i].push_back(pose_model(model, model.animations[i], frame));
  set_bounds(posed, mdl);
  mdl.average_triangle_size = static_cast<float>(mean_area(model.mesh, posed.front().front().positions));
  for (std::size_t i = 0; i < posed.size(); ++i) {
    // An animation becomes a frame for each pose, or one frame group with all poses.
    formats::MdlFrame group;
    group.mins.position = {255, 255, 255};
    for (const PosedModel& pose : posed[i]) {
      const MdlPose packed = pack(pose, model.mesh, file, mdl);
      if (model.animations[i].group_frame_s <= 0) {
        mdl.frames.push_back({{packed}, {}, {}, {}});
        continue;
      }
      merge_bounds(packed, group);
      group.poses.push_back(packed);
      group.end_times_s.push_back(
          static_cast<float>(model.animations[i].group_frame_s * static_cast<double>(group.poses.size())));
    }
    if (!group.poses.empty()) mdl.frames.push_back(group);
  }
  return mdl;
}

base::Result<std::vector<ArtPart>> make_model_art(const ScriptLine& asset) {
  TRY(const Model model, read_model(asset));
  const Mdl mdl = make_mdl(model);
  if (mdl.bounding_radius > kMaxRadius)
    return script_error(asset, fmt::format("it reaches {:.0f} units from its origin; the limit is {}",
                                           mdl.bounding_radius, kMaxRadius));
  std::vector<ArtPart> parts;
  parts.push_back({model.path, formats::write_mdl(mdl)});
  return parts;
}

}  // namespace temblor::artgen
