#include "support/models/posed_samples.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "base/check.h"

namespace temblor::test {
namespace {

constexpr std::size_t kMd3Name = 64, kMd3FrameName = 16;

void write_vec3(base::ByteWriter& io_writer, const math::Vec3& v) {
  for (int axis = 0; axis < 3; ++axis) io_writer.f32(v[axis]);
}

std::uint32_t list_size(const auto& list) {
  return static_cast<std::uint32_t>(list.size());
}

void write_surface(base::ByteWriter& io_writer, const formats::Md3Surface& surface, std::uint32_t frames) {
  const std::size_t start = io_writer.size();
  io_writer.fixed_text("IDP3", 4);
  io_writer.fixed_text(surface.name, kMd3Name);
  for (const std::uint32_t value :
       {0u, frames, list_size(surface.shaders), list_size(surface.texels), list_size(surface.triangles)})
    io_writer.u32(value);
  const std::size_t offsets = io_writer.size();
  for (int i = 0; i < 5; ++i) io_writer.u32(0);
  const auto begin_part = [&](std::size_t part) {
    io_writer.patch(offsets + part * 4, static_cast<std::uint32_t>(io_writer.size() - start));
  };
  begin_part(0);
  for (const auto& triangle : surface.triangles)
    for (const std::uint32_t vertex : triangle) io_writer.u32(vertex);
  begin_part(1);
  for (const std::string& shader : surface.shaders) {
    io_writer.fixed_text(shader, kMd3Name);
    io_writer.u32(0);
  }
  begin_part(2);
  for (const math::Vec2& texel : surface.texels) {
    io_writer.f32(texel.x);
    io_writer.f32(texel.y);
  }
  begin_part(3);
  for (const formats::Md3Vertex& vertex : surface.vertices) {
    for (const std::int16_t coordinate : vertex.position) io_writer.i16(coordinate);
    io_writer.u8(vertex.zenith);
    io_writer.u8(vertex.azimuth);
  }
  begin_part(4);
}

// The vertices of an MDL file, those on the seam once for each side that uses them.
struct SplitMdl {
  std::vector<std::uint32_t> sources;  // by vertex: the file's vertex
  std::vector<math::Vec2> texels;      // 0 to 1
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<const formats::MdlPose*> poses;
};

SplitMdl split(const formats::Mdl& mdl) {
  SplitMdl split;
  std::map<std::pair<std::uint32_t, bool>, std::uint32_t> numbers;
  for (const formats::MdlTriangle& triangle : mdl.triangles) {
    auto& corners = split.triangles.emplace_back();
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const std::uint32_t vertex = triangle.vertices[corner];
      const formats::MdlTexel& texel = mdl.texels[vertex];
      const bool is_shifted = texel.on_seam && !triangle.faces_front;
      const auto [found, is_new] = numbers.try_emplace({vertex, is_shifted}, list_size(split.sources));
      corners[corner] = found->second;
      if (!is_new) continue;
      split.sources.push_back(vertex);
      const double s = texel.s + 0.5 + (is_shifted ? mdl.skin_width / 2 : 0u);
      split.texels.emplace_back(s / mdl.skin_width, (texel.t + 0.5) / mdl.skin_height);
    }
  }
  for (const formats::MdlFrame& frame : mdl.frames)
    for (const formats::MdlPose& pose : frame.poses) split.poses.push_back(&pose);
  return split;
}

math::Vec3 decode(const formats::Mdl& mdl, const formats::MdlVertex& vertex) {
  return mdl.scale * math::Vec3(vertex.position[0], vertex.position[1], vertex.position[2]) + mdl.origin;
}

std::string format_vec3(const math::Vec3& v) {
  return fmt::format("( {} {} {} )", v.x, v.y, v.z);
}

// Files leave w out: it is negative. The opposite quaternion is the same rotation.
math::Vec3 stored_orientation(const glm::quat& q) {
  return q.w > 0 ? math::Vec3(-q.x, -q.y, -q.z) : math::Vec3(q.x, q.y, q.z);
}

glm::quat turn_around_y(float radians) {
  return {std::cos(radians / 2), 0, std::sin(radians / 2), 0};
}

}  // namespace

base::ByteVector write_md3(const formats::Md3& md3) {
  base::ByteWriter writer;
  writer.fixed_text("IDP3", 4);
  writer.u32(15);
  writer.fixed_text("made by a test", kMd3Name);
  constexpr std::uint32_t kHeader = 108, kFrame = 56;
  const std::uint32_t surfaces = kHeader + kFrame * list_size(md3.frames);
  for (const std::uint32_t value :
       {md3.flags, list_size(md3.frames), 0u, list_size(md3.surfaces), 0u, kHeader, surfaces, surfaces})
    writer.u32(value);
  const std::size_t end = writer.size();
  writer.u32(0);
  for (const formats::Md3Frame& frame : md3.frames) {
    write_vec3(writer, frame.bounds.mins);
    write_vec3(writer, frame.bounds.maxs);
    write_vec3(writer, math::Vec3(0.0f));
    writer.f32(glm::distance(frame.bounds.mins, frame.bounds.maxs) / 2);
    writer.fixed_text(frame.name, kMd3FrameName);
  }
  for (const formats::Md3Surface& surface : md3.surfaces)
    write_surface(writer, surface, list_size(md3.frames));
  writer.patch(end, static_cast<std::uint32_t>(writer.size()));
  return std::move(writer).take();
}

formats::Md3 convert_to_md3(const formats::Mdl& mdl, const std::string& shader) {
  const SplitMdl vertices = split(mdl);
  formats::Md3 md3;
  md3.flags = mdl.flags;
  formats::Md3Surface& surface = md3.surfaces.emplace_back();
  surface.name = "mesh";
  surface.shaders = {shader};
  surface.texels = vertices.texels;
  surface.triangles = vertices.triangles;
  constexpr std::uint8_t kQuarterTurn = 64;
  for (const formats::MdlPose* pose : vertices.poses) {
    formats::Md3Frame& frame = md3.frames.emplace_back();
    frame.name = pose->name;
    frame.bounds = {math::Vec3(1e9f), math::Vec3(-1e9f)};
    for (const std::uint32_t source : vertices.sources) {
      const math::Vec3 place = decode(mdl, pose->vertices[source]);
      frame.bounds.mins = glm::min(frame.bounds.mins, place);
      frame.bounds.maxs = glm::max(frame.bounds.maxs, place);
      formats::Md3Vertex vertex{{}, kQuarterTurn, 0};
      for (int axis = 0; axis < 3; ++axis)
        vertex.position[static_cast<std::size_t>(axis)] =
            static_cast<std::int16_t>(std::lround(place[axis] / formats::kMd3Units));
      surface.vertices.push_back(vertex);
    }
  }
  return md3;
}

std::string write_md5_mesh(const formats::Md5Model& model) {
  std::string text =
      fmt::format("MD5Version 10\ncommandline \"\"\n\nnumJoints {}\nnumMeshes {}\n\njoints {{\n",
                  model.joints.size(), model.meshes.size());
  for (std::size_t i = 0; i < model.joints.size(); ++i)
    text += fmt::format("\t\"{}\"\t{} {} {}\n", model.joints[i].name, model.joints[i].parent,
                        format_vec3(model.bind_pose[i].position),
                        format_vec3(stored_orientation(model.bind_pose[i].orientation)));
  text += "}\n";
  for (const formats::Md5Mesh& mesh : model.meshes) {
    text += fmt::format("\nmesh {{\n\tshader \"{}\"\n\n\tnumverts {}\n", mesh.shader, mesh.vertices.size());
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
      text +=
          fmt::format("\tvert {} ( {} {} ) {} {}\n", i, mesh.vertices[i].texel.x, mesh.vertices[i].texel.y,
                      mesh.vertices[i].first_weight, mesh.vertices[i].weight_count);
    text += fmt::format("\n\tnumtris {}\n", mesh.triangles.size());
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
      text += fmt::format("\ttri {} {} {} {}\n", i, mesh.triangles[i][0], mesh.triangles[i][1],
                          mesh.triangles[i][2]);
    text += fmt::format("\n\tnumweights {}\n", mesh.weights.size());
    for (std::size_t i = 0; i < mesh.weights.size(); ++i)
      text += fmt::format("\tweight {} {} {} {}\n", i, mesh.weights[i].joint, mesh.weights[i].bias,
                          format_vec3(mesh.weights[i].position));
    text += "}\n";
  }
  return text;
}

std::string write_md5_animation(const std::vector<formats::Md5Joint>& joints, const Md5Frames& frames) {
  std::string text = fmt::format(
      "MD5Version 10\ncommandline \"\"\n\nnumFrames {}\nnumJoints {}\nframeRate 10\n"
      "numAnimatedComponents {}\n\nhierarchy {{\n",
      frames.size(), joints.size(), joints.size() * 6);
  for (std::size_t i = 0; i < joints.size(); ++i)
    text += fmt::format("\t\"{}\"\t{} 63 {}\n", joints[i].name, joints[i].parent, i * 6);
  text += "}\n\nbounds {\n";
  for (std::size_t i = 0; i < frames.size(); ++i) text += "\t( 0 0 0 ) ( 0 0 0 )\n";
  text += "}\n\nbaseframe {\n";
  for (std::size_t i = 0; i < joints.size(); ++i) text += "\t( 0 0 0 ) ( 0 0 0 )\n";
  text += "}\n";
  for (std::size_t number = 0; number < frames.size(); ++number) {
    text += fmt::format("\nframe {} {{\n", number);
    for (const formats::Md5JointPose& joint : frames[number]) {
      const math::Vec3 turn = stored_orientation(joint.orientation);
      text += fmt::format("\t{} {} {} {} {} {}\n", joint.position.x, joint.position.y, joint.position.z,
                          turn.x, turn.y, turn.z);
    }
    text += "}\n";
  }
  return text;
}

Md5Sample convert_to_md5(const formats::Mdl& mdl, const std::string& shader) {
  const SplitMdl vertices = split(mdl);
  CHECK(vertices.sources.size() <= formats::kMaxMd5Joints, "{}", vertices.sources.size());
  formats::Md5Model model;
  Md5Frames frames;
  for (const formats::MdlPose* pose : vertices.poses) {
    auto& frame = frames.emplace_back();
    for (const std::uint32_t source : vertices.sources)
      frame.push_back({decode(mdl, pose->vertices[source])});
  }
  model.bind_pose = frames.front();
  formats::Md5Mesh& mesh = model.meshes.emplace_back();
  mesh.shader = shader;
  mesh.triangles = vertices.triangles;
  for (std::uint32_t i = 0; i < list_size(vertices.sources); ++i) {
    model.joints.push_back({fmt::format("vertex{}", i), -1});
    mesh.vertices.push_back({vertices.texels[i], i, 1});
    mesh.weights.push_back({i, 1, math::Vec3(0.0f)});
  }
  return {write_md5_mesh(model), write_md5_animation(model.joints, frames)};
}

Md5Sample bending_column(std::uint32_t sides, std::uint32_t rings, std::uint32_t frames,
                         const std::string& shader) {
  constexpr float kHeight = 96, kRadius = 12, kMaxBend = 0.6f;
  constexpr std::uint32_t kJoints = 3;
  constexpr float kBone = kHeight / kJoints;
  formats::Md5Model model;
  Md5Frames posed(frames);
  for (std::uint32_t joint = 0; joint < kJoints; ++joint) {
    model.joints.push_back({fmt::format("joint{}", joint), static_cast<std::int32_t>(joint) - 1});
    const float up = static_cast<float>(joint) * kBone;
    model.bind_pose.push_back({{0, 0, up}, glm::identity<glm::quat>()});
    for (std::uint32_t frame = 0; frame < frames; ++frame) {
      const float phase =
          2 * std::numbers::pi_v<float> * static_cast<float>(frame) / static_cast<float>(frames);
      posed[frame].push_back({{0, 0, joint == 0 ? 0.0f : kBone}, turn_around_y(kMaxBend * std::sin(phase))});
    }
  }
  formats::Md5Mesh& mesh = model.meshes.emplace_back();
  mesh.shader = shader;
  for (std::uint32_t ring = 0; ring <= rings; ++ring)
    for (std::uint32_t side = 0; side <= sides; ++side) {
      const float around = static_cast<float>(side % sides) / static_cast<float>(sides);
      const float along = static_cast<float>(ring) / static_cast<float>(rings);
      const float angle = 2 * std::numbers::pi_v<float> * around;
      const math::Vec3 place{kRadius * std::cos(angle), kRadius * std::sin(angle), kHeight * along};
      const float bones = std::min(along * kJoints, kJoints - 0.001f);
      const auto upper = static_cast<std::uint32_t>(bones);
      const float share = bones - static_cast<float>(upper);
      const std::uint32_t lower = upper == 0 ? 0 : upper - 1;
      mesh.vertices.push_back(
          {{static_cast<float>(side) / static_cast<float>(sides), 1 - along}, list_size(mesh.weights), 2});
      mesh.weights.push_back({upper, 0.5f + share / 2, place - model.bind_pose[upper].position});
      mesh.weights.push_back({lower, 0.5f - share / 2, place - model.bind_pose[lower].position});
    }
  const std::uint32_t row = sides + 1;
  for (std::uint32_t ring = 0; ring < rings; ++ring)
    for (std::uint32_t side = 0; side < sides; ++side) {
      const std::uint32_t low = ring * row + side, high = low + row;
      // Counterclockwise seen from above is to the right from outside.
      mesh.triangles.push_back({low, high, high + 1});
      mesh.triangles.push_back({low, high + 1, low + 1});
    }
  return {write_md5_mesh(model), write_md5_animation(model.joints, posed)};
}

}  // namespace temblor::test
