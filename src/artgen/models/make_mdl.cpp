// Poses to bytes, triangles to corners with texels, skins.
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

constexpr double kPoseByteSteps = 255;
constexpr std::size_t kMaxNameChars = 15;
constexpr float kFarthest = 65536;  // units

// The file's vertices: a point once for every normal and every place on the skin that it has.
struct FileVertex {
  std::uint32_t point = 0, smooth = 0;
};

struct FileMesh {
  std::vector<FileVertex> vertices;
  std::vector<formats::MdlTexel> texels;
  std::vector<formats::MdlTriangle> triangles;
};

FileMesh number_vertices(const Mesh& mesh, const Atlas& atlas) {
  FileMesh file;
  std::map<std::tuple<std::uint32_t, std::uint32_t, std::int32_t, std::int32_t>, std::uint32_t> known;
  for (const MeshTriangle& triangle : mesh.triangles) {
    formats::MdlTriangle made;
    for (std::size_t i = 0; i < 3; ++i) {
      const MeshCorner& corner = triangle.corners[i];
      const math::Vec2d texel = atlas.texel(triangle.chart, corner.place);
      const auto s = static_cast<std::int32_t>(texel.x), t = static_cast<std::int32_t>(texel.y);
      const auto next = static_cast<std::uint32_t>(file.vertices.size());
      const auto [entry, is_new] = known.try_emplace({corner.point, triangle.smooth, s, t}, next);
      if (is_new) {
        file.vertices.push_back({corner.point, triangle.smooth});
        file.texels.push_back({false, s, t});
      }
      made.vertices[2 - i] = entry->second;  // clockwise
    }
    file.triangles.push_back(made);
  }
  return file;
}

struct Shown {
  std::string name;
  std::vector<Vec3d> places;  // by point
};

Shown show(const Model& model, const Animation& animation, std::int32_t frame) {
  const auto stance = model.poses.find("stance");
  const ChannelValues base = stance != model.poses.end() ? stance->second : ChannelValues{};
  const BonePose pose = pose_at(animation, model.skeleton, base, frame);
  Shown shown;
  shown.name = fmt::format("{}{}", animation.name, frame + 1).substr(0, kMaxNameChars);
  shown.places = place_points(model.mesh, rest_places(model.skeleton), place_bones(model.skeleton, pose));
  if (animation.settles) {
    double lowest = shown.places.front().z;
    for (const Vec3d& place : shown.places) lowest = std::min(lowest, place.z);
    for (Vec3d& place : shown.places) place.z += model.floor - lowest;
  }
  const Vec3d middle(0, 0, model.floor);
  for (Vec3d& place : shown.places) place = middle + (place - middle) * model.size;
  return shown;
}

std::uint8_t nearest_normal(const Vec3d& normal) {
  const auto all = formats::mdl_normals();
  std::size_t best = 0;
  for (std::size_t i = 1; i < all.size(); ++i)
    if (glm::dot(Vec3d(all[i]), normal) > glm::dot(Vec3d(all[best]), normal)) best = i;
  return static_cast<std::uint8_t>(best);
}

// By smooth number and point.
std::map<std::pair<std::uint32_t, std::uint32_t>, Vec3d> normals_of(const Mesh& mesh,
                                                                    const std::vector<Vec3d>& places) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, Vec3d> sums;
  for (const MeshTriangle& triangle : mesh.triangles) {
    const auto& corners = triangle.corners;
    const Vec3d area = glm::cross(places[corners[1].point] - places[corners[0].point],
                                  places[corners[2].point] - places[corners[0].point]);
    for (const MeshCorner& corner : corners) sums[{triangle.smooth, corner.point}] += area;
  }
  return sums;
}

MdlPose pack(const Shown& shown, const Mesh& mesh, const FileMesh& file, const Mdl& mdl) {
  MdlPose pose;
  pose.name = shown.name;
  pose.mins.position = {255, 255, 255};
  const auto normals = normals_of(mesh, shown.places);
  for (const FileVertex& vertex : file.vertices) {
    MdlVertex made;
    const Vec3d steps = (shown.places[vertex.point] - Vec3d(mdl.origin)) / Vec3d(mdl.scale);
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

void set_bounds(const std::vector<std::vector<Shown>>& animations, Mdl& out_mdl) {
  Vec3d low(1e9), high(-1e9);
  double radius = 0;
  for (const auto& shown_frames : animations)
    for (const Shown& shown : shown_frames)
      for (const Vec3d& place : shown.places) {
        low = glm::min(low, place);
        high = glm::max(high, place);
        radius = std::max(radius, glm::length(place));
      }
  out_mdl.origin = math::Vec3(low);
  out_mdl.scale = math::Vec3(glm::max((high - low) / kPoseByteSteps, Vec3d(1e-4)));
  out_mdl.bounding_radius = static_cast<float>(radius);
}

double mean_area(const Mesh& mesh, const std::vector<Vec3d>& places) {
  double sum = 0;
  for (const MeshTriangle& triangle : mesh.triangles)
    sum +=
        0.5 * glm::length(glm::cross(places[triangle.corners[1].point] - places[triangle.corners[0].point],
                                     places[triangle.corners[2].point] - places[triangle.corners[0].point]));
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

  std::vector<std::vector<Shown>> shown(model.animations.size());
  for (std::size_t i = 0; i < shown.size(); ++i)
    for (std::int32_t frame = 0; frame < model.animations[i].frames; ++frame)
      shown[i].push_back(show(model, model.animations[i], frame));
  set_bounds(shown, mdl);
  mdl.average_triangle_size = static_cast<float>(mean_area(model.mesh, shown.front().front().places));
  for (std::size_t i = 0; i < shown.size(); ++i) {
    formats::MdlFrame group;
    group.mins.position = {255, 255, 255};
    for (const Shown& pose : shown[i]) {
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

base::Result<std::vector<ArtPart>> make_model_art(const ScriptLine& thing) {
  TRY(const Model model, read_model(thing));
  const Mdl mdl = make_mdl(model);
  if (mdl.bounding_radius > kFarthest)
    return script_error(thing, fmt::format("it reaches {:.0f} units from its origin, the farthest is {}",
                                           mdl.bounding_radius, kFarthest));
  std::vector<ArtPart> parts;
  parts.push_back({model.path, formats::write_mdl(mdl)});
  return parts;
}

}  // namespace temblor::artgen
