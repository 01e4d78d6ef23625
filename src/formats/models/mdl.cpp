#include "formats/models/mdl.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "base/check.h"
#include "formats/models/model_bytes.h"

namespace temblor::formats {
namespace {

constexpr FileKind kFile{"model", "IDPO", 6};
constexpr std::size_t kMdlHeaderBytes = 84;
constexpr std::size_t kTexelBytes = 12, kTriangleBytes = 16, kVertexBytes = 4, kFrameNameBytes = 16;
constexpr std::int32_t kSeam = 32;
constexpr std::size_t kMaxFrameNameChars = kFrameNameBytes - 1;

// Counts from the header.
struct Counts {
  std::uint32_t skins = 0, vertices = 0, triangles = 0, frames = 0;
};

bool is_finite(const math::Vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// Returns the largest coordinate that a vertex can have, in units.
float reach(const math::Vec3& scale, const math::Vec3& origin) {
  const math::Vec3 far_corner = glm::abs(scale) * 255.0f + glm::abs(origin);
  return std::max({far_corner.x, far_corner.y, far_corner.z});
}

bool is_texel(const MdlTexel& texel) {
  return std::min(texel.s, texel.t) >= -kMaxMdlTexel && std::max(texel.s, texel.t) <= kMaxMdlTexel;
}

base::Result<math::Vec3> read_finite_vec3(base::ByteReader& io_reader, std::string_view what) {
  math::Vec3 v{0.0f};
  for (int axis = 0; axis < 3; ++axis) {
    TRY(v[axis], read_finite(io_reader, what));
  }
  return v;
}

void write_vec3(base::ByteWriter& io_writer, const math::Vec3& v) {
  for (int axis = 0; axis < 3; ++axis) io_writer.f32(v[axis]);
}

MdlVertex read_vertex(base::ByteReader& io_reader) {
  MdlVertex vertex;
  for (std::uint8_t& byte : vertex.position) byte = io_reader.u8();
  vertex.normal = io_reader.u8();
  return vertex;
}

void write_vertex(base::ByteWriter& io_writer, const MdlVertex& vertex) {
  for (const std::uint8_t byte : vertex.position) io_writer.u8(byte);
  io_writer.u8(vertex.normal);
}

// Checks a number of the header: at least 1, because an empty model cannot be drawn.
base::Status check_count(const char* what, std::size_t offset, std::uint32_t count, std::uint32_t limit) {
  if (count == 0) return base::malformed("header at offset {:#x}: no {}", offset, what);
  if (count > limit)
    return base::error(base::ErrorCode::kTooLarge, "header at offset {:#x}: {} {}, the limit is {}", offset,
                       count, what, limit);
  return base::Ok{};
}

// Stores the fields of the model, and returns the counts of the parts that follow.
base::Result<Counts> read_header(base::ByteReader& io_reader, Mdl& out_mdl) {
  TRY_STATUS(read_file_kind(io_reader, kFile, kMdlHeaderBytes));
  const std::size_t scale_offset = io_reader.offset();
  TRY(out_mdl.scale, read_finite_vec3(io_reader, "scale"));
  TRY(out_mdl.origin, read_finite_vec3(io_reader, "origin"));
  if (const float far_corner = reach(out_mdl.scale, out_mdl.origin); far_corner > kMaxMdlCoordinate)
    return base::error(base::ErrorCode::kTooLarge,
                       "header at offset {:#x}: scale and origin put vertices {} units away, the limit is {}",
                       scale_offset, far_corner, kMaxMdlCoordinate);
  out_mdl.bounding_radius = read_unused_number(io_reader);
  for (int axis = 0; axis < 3; ++axis) out_mdl.eye[axis] = read_unused_number(io_reader);

  Counts counts;
  const auto read_count = [&](const char* what, std::uint32_t limit, std::uint32_t& out_count) {
    const std::size_t offset = io_reader.offset();
    out_count = io_reader.u32();
    return check_count(what, offset, out_count, limit);
  };
  TRY_STATUS(read_count("skins", kMaxMdlSkins, counts.skins));
  TRY_STATUS(read_count("texels of skin width", kMaxMdlSkinSide, out_mdl.skin_width));
  TRY_STATUS(read_count("texels of skin height", kMaxMdlSkinSide, out_mdl.skin_height));
  TRY_STATUS(read_count("vertices", kMaxMdlVertices, counts.vertices));
  TRY_STATUS(read_count("triangles", kMaxMdlTriangles, counts.triangles));
  TRY_STATUS(read_count("frames", kMaxMdlPoses, counts.frames));
  out_mdl.random_phase = io_reader.i32() != 0;
  out_mdl.flags = io_reader.u32();
  out_mdl.average_triangle_size = read_unused_number(io_reader);
  return counts;
}

base::Result<MdlSkin> read_skin(base::ByteReader& io_reader, const Mdl& mdl, std::string_view part) {
  MdlSkin skin;
  TRY(const std::uint32_t members, read_group_members(io_reader, part));
  if (members > 0) {
    TRY(skin.end_times_s, read_group_times(io_reader, members, part));
  }
  const std::size_t texels = std::size_t{mdl.skin_width} * mdl.skin_height;
  for (std::uint32_t i = 0; i < std::max(members, 1u); ++i) {
    TRY_STATUS(need_bytes(io_reader, texels, member_name(part, "picture", i, members)));
    const auto picture = base::as_u8(io_reader.take(texels));
    skin.pictures.emplace_back(picture.begin(), picture.end());
  }
  return skin;
}

base::Status read_texels(base::ByteReader& io_reader, std::uint32_t count, Mdl& out_mdl) {
  TRY_STATUS(need_bytes(io_reader, std::uint64_t{count} * kTexelBytes, "skin coordinates"));
  out_mdl.texels.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t offset = io_reader.offset();
    MdlTexel& texel = out_mdl.texels[i];
    texel.on_seam = io_reader.i32() != 0;
    texel.s = io_reader.i32();
    texel.t = io_reader.i32();
    if (!is_texel(texel))
      return base::error(base::ErrorCode::kTooLarge,
                         "skin coordinates of vertex {} at offset {:#x}: {}, {}, the limit is {}", i, offset,
                         texel.s, texel.t, kMaxMdlTexel);
  }
  return base::Ok{};
}

// Leaves out triangles with vertices that do not exist, unless no triangle is left.
base::Status read_triangles(base::ByteReader& io_reader, const Counts& counts, Mdl& out_mdl) {
  TRY_STATUS(need_bytes(io_reader, std::uint64_t{counts.triangles} * kTriangleBytes, "triangles"));
  const std::size_t offset = io_reader.offset();
  out_mdl.triangles.reserve(counts.triangles);
  for (std::size_t i = 0; i < counts.triangles; ++i) {
    MdlTriangle triangle;
    triangle.faces_front = io_reader.i32() != 0;
    for (std::uint32_t& vertex : triangle.vertices) vertex = io_reader.u32();
    if (std::ranges::all_of(triangle.vertices,
                            [&](std::uint32_t vertex) { return vertex < counts.vertices; }))
      out_mdl.triangles.push_back(triangle);
  }
  if (out_mdl.triangles.empty())
    return base::malformed("triangles at offset {:#x}: each has a vertex past the end ({})", offset,
                           counts.vertices);
  return base::Ok{};
}

// Replaces normals that do not exist, because the renderer uses them as indices. Bytes of positions may have
// any value.
base::Result<MdlPose> read_pose(base::ByteReader& io_reader, std::uint32_t vertices, std::string_view part) {
  TRY_STATUS(need_bytes(io_reader, (2 + std::uint64_t{vertices}) * kVertexBytes + kFrameNameBytes, part));
  MdlPose pose;
  pose.mins = read_vertex(io_reader);
  pose.maxs = read_vertex(io_reader);
  pose.name = io_reader.fixed_text(kFrameNameBytes).substr(0, kMaxFrameNameChars);
  pose.vertices.resize(vertices);
  for (MdlVertex& vertex : pose.vertices) {
    vertex = read_vertex(io_reader);
    if (vertex.normal >= kMdlNormals) vertex.normal = 0;
  }
  return pose;
}

base::Result<MdlFrame> read_frame(base::ByteReader& io_reader, std::uint32_t vertices,
                                  std::string_view part) {
  MdlFrame frame;
  TRY(const std::uint32_t members, read_group_members(io_reader, part));
  if (members > 0) {
    TRY_STATUS(need_bytes(io_reader, 2 * kVertexBytes, part));
    frame.mins = read_vertex(io_reader);
    frame.maxs = read_vertex(io_reader);
    TRY(frame.end_times_s, read_group_times(io_reader, members, part));
  }
  for (std::uint32_t i = 0; i < std::max(members, 1u); ++i) {
    TRY(MdlPose pose, read_pose(io_reader, vertices, member_name(part, "pose", i, members)));
    frame.poses.push_back(std::move(pose));
  }
  return frame;
}

// A file can have many groups, so the limit applies to the sum of their poses.
base::Status read_frames(base::ByteReader& io_reader, const Counts& counts, Mdl& out_mdl) {
  std::size_t poses = 0;
  for (std::uint32_t i = 0; i < counts.frames; ++i) {
    const std::size_t offset = io_reader.offset();
    TRY(MdlFrame frame, read_frame(io_reader, counts.vertices, fmt::format("frame {}", i)));
    poses += frame.poses.size();
    if (poses > kMaxMdlPoses)
      return base::error(base::ErrorCode::kTooLarge,
                         "frame {} at offset {:#x}: brings the model to {} poses, the limit is {}", i, offset,
                         poses, kMaxMdlPoses);
    out_mdl.frames.push_back(std::move(frame));
  }
  return base::Ok{};
}

void check_skin(const MdlSkin& skin, const Mdl& mdl) {
  CHECK(!skin.pictures.empty());
  CHECK(skin.end_times_s.empty() ? skin.pictures.size() == 1
                                 : skin.end_times_s.size() == skin.pictures.size());
  for (const auto& picture : skin.pictures)
    CHECK(picture.size() == std::size_t{mdl.skin_width} * mdl.skin_height, "{}", picture.size());
}

void check_frame(const MdlFrame& frame, const Mdl& mdl) {
  CHECK(!frame.poses.empty());
  CHECK(frame.end_times_s.empty() ? frame.poses.size() == 1 : frame.end_times_s.size() == frame.poses.size());
  for (const MdlPose& pose : frame.poses) {
    CHECK(pose.vertices.size() == mdl.texels.size(), "{}", pose.vertices.size());
    CHECK(pose.name.size() <= kMaxFrameNameChars, "{}", pose.name);
    for (const MdlVertex& vertex : pose.vertices) CHECK(vertex.normal < kMdlNormals, "{}", vertex.normal);
  }
}

void check_model(const Mdl& mdl) {
  CHECK(reach(mdl.scale, mdl.origin) <= kMaxMdlCoordinate, "{}", reach(mdl.scale, mdl.origin));
  CHECK(is_finite(mdl.eye) && std::isfinite(mdl.bounding_radius) && std::isfinite(mdl.average_triangle_size));
  const auto in_range = [](std::size_t count, std::size_t limit) { return count >= 1 && count <= limit; };
  CHECK(in_range(mdl.skins.size(), kMaxMdlSkins), "{}", mdl.skins.size());
  CHECK(in_range(mdl.skin_width, kMaxMdlSkinSide) && in_range(mdl.skin_height, kMaxMdlSkinSide), "{} x {}",
        mdl.skin_width, mdl.skin_height);
  CHECK(in_range(mdl.texels.size(), kMaxMdlVertices), "{}", mdl.texels.size());
  for (const MdlTexel& texel : mdl.texels) CHECK(is_texel(texel), "{}, {}", texel.s, texel.t);
  CHECK(in_range(mdl.triangles.size(), kMaxMdlTriangles), "{}", mdl.triangles.size());
  for (const MdlTriangle& triangle : mdl.triangles)
    for (const std::uint32_t vertex : triangle.vertices) CHECK(vertex < mdl.texels.size(), "{}", vertex);
  for (const MdlSkin& skin : mdl.skins) check_skin(skin, mdl);
  std::size_t poses = 0;
  for (const MdlFrame& frame : mdl.frames) {
    check_frame(frame, mdl);
    poses += frame.poses.size();
  }
  CHECK(in_range(poses, kMaxMdlPoses), "{}", poses);
}

void write_header(base::ByteWriter& io_writer, const Mdl& mdl) {
  write_file_kind(io_writer, kFile);
  write_vec3(io_writer, mdl.scale);
  write_vec3(io_writer, mdl.origin);
  io_writer.f32(mdl.bounding_radius);
  write_vec3(io_writer, mdl.eye);
  io_writer.u32(static_cast<std::uint32_t>(mdl.skins.size()));
  io_writer.u32(mdl.skin_width);
  io_writer.u32(mdl.skin_height);
  io_writer.u32(static_cast<std::uint32_t>(mdl.texels.size()));
  io_writer.u32(static_cast<std::uint32_t>(mdl.triangles.size()));
  io_writer.u32(static_cast<std::uint32_t>(mdl.frames.size()));
  io_writer.i32(mdl.random_phase ? 1 : 0);
  io_writer.u32(mdl.flags);
  io_writer.f32(mdl.average_triangle_size);
}

void write_skin(base::ByteWriter& io_writer, const MdlSkin& skin) {
  write_group_members(io_writer, skin.end_times_s.size());
  write_group_times(io_writer, skin.end_times_s);
  for (const auto& picture : skin.pictures) io_writer.bytes(std::as_bytes(std::span(picture)));
}

void write_frame(base::ByteWriter& io_writer, const MdlFrame& frame) {
  write_group_members(io_writer, frame.end_times_s.size());
  if (!frame.end_times_s.empty()) {
    write_vertex(io_writer, frame.mins);
    write_vertex(io_writer, frame.maxs);
    write_group_times(io_writer, frame.end_times_s);
  }
  for (const MdlPose& pose : frame.poses) {
    write_vertex(io_writer, pose.mins);
    write_vertex(io_writer, pose.maxs);
    io_writer.fixed_text(pose.name, kFrameNameBytes);
    for (const MdlVertex& vertex : pose.vertices) write_vertex(io_writer, vertex);
  }
}

}  // namespace

base::Result<Mdl> read_mdl(base::Bytes bytes) {
  base::ByteReader reader(bytes);
  Mdl mdl;
  TRY(const Counts counts, read_header(reader, mdl));
  for (std::uint32_t i = 0; i < counts.skins; ++i) {
    TRY(MdlSkin skin, read_skin(reader, mdl, fmt::format("skin {}", i)));
    mdl.skins.push_back(std::move(skin));
  }
  TRY_STATUS(read_texels(reader, counts.vertices, mdl));
  TRY_STATUS(read_triangles(reader, counts, mdl));
  TRY_STATUS(read_frames(reader, counts, mdl));
  return mdl;
}

base::ByteVector write_mdl(const Mdl& mdl) {
  check_model(mdl);
  base::ByteWriter writer;
  write_header(writer, mdl);
  for (const MdlSkin& skin : mdl.skins) write_skin(writer, skin);
  for (const MdlTexel& texel : mdl.texels) {
    writer.i32(texel.on_seam ? kSeam : 0);
    writer.i32(texel.s);
    writer.i32(texel.t);
  }
  for (const MdlTriangle& triangle : mdl.triangles) {
    writer.i32(triangle.faces_front ? 1 : 0);
    for (const std::uint32_t vertex : triangle.vertices) writer.u32(vertex);
  }
  for (const MdlFrame& frame : mdl.frames) write_frame(writer, frame);
  return std::move(writer).take();
}

}  // namespace temblor::formats
