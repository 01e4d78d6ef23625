#include "formats/models/md3.h"

#include <fmt/format.h>

#include <cmath>

#include "formats/models/model_bytes.h"

namespace temblor::formats {
namespace {

constexpr FileKind kMd3File{"MD3 model", "IDP3", 15};
constexpr std::size_t kMd3HeaderBytes = 108, kMd3FrameBytes = 56, kMd3SurfaceBytes = 108;
constexpr std::size_t kShaderBytes = 68, kMd3TriangleBytes = 12, kMd3TexelBytes = 8, kMd3VertexBytes = 8;
constexpr std::size_t kMd3NameBytes = 64, kMd3FrameNameBytes = 16;

// An array of a file: `count` records from `offset` on.
struct Table {
  std::string name;
  std::size_t offset = 0;
  std::uint32_t count = 0;
};

base::Result<std::uint32_t> read_limited(base::ByteReader& io_reader, std::string_view part,
                                         std::uint32_t min, std::uint32_t max) {
  const std::size_t offset = io_reader.offset();
  const std::uint32_t count = io_reader.u32();
  if (count < min)
    return base::malformed("offset {:#x}: {} {}, at least {} is needed", offset, count, part, min);
  if (count > max)
    return base::error(base::ErrorCode::kTooLarge, "offset {:#x}: {} {}, the limit is {}", offset, count,
                       part, max);
  return count;
}

// Moves to the table, after a check that the file has all of it.
base::Status enter(base::ByteReader& io_reader, const Table& table, std::size_t record_bytes) {
  io_reader.seek(table.offset);
  if (!io_reader.ok())
    return base::malformed("{} at offset {:#x}: the file ends before it", table.name, table.offset);
  return need_bytes(io_reader, std::uint64_t{table.count} * record_bytes, table.name);
}

base::Result<math::Vec3> read_corner(base::ByteReader& io_reader, std::string_view part) {
  const std::size_t offset = io_reader.offset();
  math::Vec3 corner{0.0f};
  for (int axis = 0; axis < 3; ++axis) corner[axis] = io_reader.f32();
  if (!std::isfinite(corner.x) || !std::isfinite(corner.y) || !std::isfinite(corner.z))
    return base::malformed("{} at offset {:#x}: its box is not finite", part, offset);
  return corner;
}

base::Status read_frames(base::ByteReader& io_reader, const Table& table, Md3& out_md3) {
  TRY_STATUS(enter(io_reader, table, kMd3FrameBytes));
  for (std::uint32_t number = 0; number < table.count; ++number) {
    const std::string part = fmt::format("frame {}", number);
    Md3Frame frame;
    TRY(frame.bounds.mins, read_corner(io_reader, part));
    TRY(frame.bounds.maxs, read_corner(io_reader, part));
    io_reader.take(4 * sizeof(float));  // origin and radius
    frame.name = io_reader.fixed_text(kMd3FrameNameBytes);
    out_md3.frames.push_back(std::move(frame));
  }
  return base::Ok{};
}

base::Status read_shaders(base::ByteReader& io_reader, const Table& table, Md3Surface& out_surface) {
  TRY_STATUS(enter(io_reader, table, kShaderBytes));
  for (std::uint32_t number = 0; number < table.count; ++number) {
    out_surface.shaders.push_back(io_reader.fixed_text(kMd3NameBytes));
    io_reader.i32();  // Quake III's number for it
  }
  return base::Ok{};
}

base::Status read_md3_triangles(base::ByteReader& io_reader, const Table& table, std::uint32_t vertex_count,
                                Md3Surface& out_surface) {
  TRY_STATUS(enter(io_reader, table, kMd3TriangleBytes));
  for (std::uint32_t number = 0; number < table.count; ++number) {
    const std::size_t offset = io_reader.offset();
    std::array<std::uint32_t, 3>& triangle = out_surface.triangles.emplace_back();
    for (std::uint32_t& vertex : triangle) {
      vertex = io_reader.u32();
      if (vertex >= vertex_count)
        return base::malformed("{} at offset {:#x}: triangle {} has vertex {} of {}", table.name, offset,
                               number, vertex, vertex_count);
    }
  }
  return base::Ok{};
}

base::Status read_md3_texels(base::ByteReader& io_reader, const Table& table, Md3Surface& out_surface) {
  TRY_STATUS(enter(io_reader, table, kMd3TexelBytes));
  for (std::uint32_t number = 0; number < table.count; ++number) {
    const std::size_t offset = io_reader.offset();
    const float s = io_reader.f32(), t = io_reader.f32();
    if (!(std::abs(s) <= kMaxMd3Texel) || !(std::abs(t) <= kMaxMd3Texel))
      return base::malformed("{} at offset {:#x}: {}, {} of vertex {} are not within {}", table.name, offset,
                             s, t, number, kMaxMd3Texel);
    out_surface.texels.emplace_back(s, t);
  }
  return base::Ok{};
}

base::Status read_md3_vertices(base::ByteReader& io_reader, const Table& table, Md3Surface& out_surface) {
  TRY_STATUS(enter(io_reader, table, kMd3VertexBytes));
  out_surface.vertices.reserve(table.count);
  for (std::uint32_t number = 0; number < table.count; ++number) {
    Md3Vertex vertex;
    for (std::int16_t& coordinate : vertex.position) coordinate = io_reader.i16();
    vertex.zenith = io_reader.u8();
    vertex.azimuth = io_reader.u8();
    out_surface.vertices.push_back(vertex);
  }
  return base::Ok{};
}

struct ReadSurface {
  Md3Surface surface;
  std::size_t end = 0;  // the offset of the next surface
};

base::Result<ReadSurface> read_surface(base::ByteReader& io_reader, std::uint32_t number,
                                       std::size_t frames) {
  const std::size_t start = io_reader.offset();
  const std::string part = fmt::format("surface {}", number);
  TRY_STATUS(need_bytes(io_reader, kMd3SurfaceBytes, part));
  if (base::as_text(io_reader.take(kMd3File.magic.size())) != kMd3File.magic)
    return base::malformed("{} at offset {:#x}: it does not start with \"{}\"", part, start, kMd3File.magic);
  ReadSurface read;
  read.surface.name = io_reader.fixed_text(kMd3NameBytes);
  io_reader.i32();  // flags, always 0
  if (const std::uint32_t own_frames = io_reader.u32(); own_frames != frames)
    return base::malformed("{} at offset {:#x}: it has {} frames, but the model has {}", part, start,
                           own_frames, frames);
  TRY(const std::uint32_t shaders, read_limited(io_reader, "shaders", 0, kMaxMd3Shaders));
  TRY(const std::uint32_t vertices, read_limited(io_reader, "vertices", 1, kMaxMd3Vertices));
  TRY(const std::uint32_t triangles, read_limited(io_reader, "triangles", 0, kMaxMd3Triangles));
  const std::size_t posed = std::size_t{vertices} * frames;
  if (posed > kMaxMd3PosedVertices)
    return base::error(base::ErrorCode::kTooLarge,
                       "{} at offset {:#x}: {} vertices in {} frames are too many", part, start, vertices,
                       frames);
  const auto table = [&](const char* name, std::size_t count) {
    return Table{fmt::format("{} of {}", name, part), start + io_reader.u32(),
                 static_cast<std::uint32_t>(count)};
  };
  const Table triangle_table = table("triangles", triangles), shader_table = table("shaders", shaders);
  const Table texel_table = table("texels", vertices), vertex_table = table("vertices", posed);
  read.end = start + io_reader.u32();
  TRY_STATUS(read_md3_triangles(io_reader, triangle_table, vertices, read.surface));
  TRY_STATUS(read_shaders(io_reader, shader_table, read.surface));
  TRY_STATUS(read_md3_texels(io_reader, texel_table, read.surface));
  TRY_STATUS(read_md3_vertices(io_reader, vertex_table, read.surface));
  return read;
}

}  // namespace

base::Result<Md3> read_md3(base::Bytes bytes) {
  base::ByteReader reader(bytes);
  TRY_STATUS(read_file_kind(reader, kMd3File, kMd3HeaderBytes));
  Md3 md3;
  reader.take(kMd3NameBytes);
  md3.flags = reader.u32();
  TRY(const std::uint32_t frames, read_limited(reader, "frames", 1, kMaxMd3Frames));
  reader.u32();  // number of tags
  TRY(const std::uint32_t surfaces, read_limited(reader, "surfaces", 1, kMaxMd3Surfaces));
  reader.u32();  // number of skins, always 0
  const std::size_t frames_offset = reader.u32();
  reader.u32();  // offset of the tags
  std::size_t surface_offset = reader.u32();
  TRY_STATUS(read_frames(reader, {"frames", frames_offset, frames}, md3));
  std::size_t posed_vertices = 0;
  for (std::uint32_t number = 0; number < surfaces; ++number) {
    TRY_STATUS(enter(reader, {fmt::format("surface {}", number), surface_offset, 1}, kMd3SurfaceBytes));
    TRY(ReadSurface read, read_surface(reader, number, frames));
    posed_vertices += read.surface.vertices.size();
    if (posed_vertices > kMaxMd3PosedVertices)
      return base::error(base::ErrorCode::kTooLarge,
                         "surface {} at offset {:#x}: more than {} vertices in {} frames", number,
                         surface_offset, kMaxMd3PosedVertices, frames);
    md3.surfaces.push_back(std::move(read.surface));
    surface_offset = read.end;
  }
  return md3;
}

}  // namespace temblor::formats
