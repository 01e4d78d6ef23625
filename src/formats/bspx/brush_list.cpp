#include "formats/bspx/brush_list.h"

#include <cmath>
#include <limits>

#include "base/check.h"

namespace temblor::formats {
namespace {

constexpr std::uint32_t kBrushListVersion = 1;
constexpr std::size_t kBrushBytes = 28, kListedPlaneBytes = 16;

math::Vec3 read_corner(base::ByteReader& io_reader) {
  math::Vec3 corner;
  for (int axis = 0; axis < 3; ++axis) corner[axis] = io_reader.f32();
  return corner;
}

void write_corner(const math::Vec3& corner, base::ByteWriter& io_writer) {
  for (int axis = 0; axis < 3; ++axis) io_writer.f32(corner[axis]);
}

bool is_finite(const math::Vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

base::Error cut_off(const base::ByteReader& reader) {
  return base::malformed("lump {}: it ends within the record at offset {}", kBrushListLump, reader.offset());
}

base::Result<ListedBrush> read_listed_brush(base::ByteReader& io_reader) {
  const std::size_t offset = io_reader.offset();
  ListedBrush brush;
  brush.mins = read_corner(io_reader);
  brush.maxs = read_corner(io_reader);
  brush.contents = io_reader.i16();
  const std::size_t planes = io_reader.u16();
  if (planes > io_reader.remaining() / kListedPlaneBytes) return cut_off(io_reader);
  brush.planes.reserve(planes);
  bool is_valid = is_finite(brush.mins) && is_finite(brush.maxs);
  for (std::size_t i = 0; i < planes; ++i) {
    ListedPlane& plane = brush.planes.emplace_back();
    plane.normal = read_corner(io_reader);
    plane.distance = io_reader.f32();
    is_valid = is_valid && is_finite(plane.normal) && std::isfinite(plane.distance);
  }
  if (!is_valid)
    return base::malformed("lump {}: the brush at offset {} has numbers that are not finite", kBrushListLump,
                           offset);
  return brush;
}

}  // namespace

base::Result<std::vector<ListedModel>> read_brush_list(base::Bytes lump) {
  base::ByteReader reader(lump);
  std::vector<ListedModel> models;
  while (reader.remaining() > 0) {
    const std::size_t offset = reader.offset();
    const std::uint32_t version = reader.u32();
    ListedModel& model = models.emplace_back();
    model.model = reader.u32();
    const std::uint32_t brushes = reader.u32(), planes = reader.u32();
    if (!reader.ok() || brushes > reader.remaining() / kBrushBytes) return cut_off(reader);
    if (version != kBrushListVersion)
      return base::malformed("lump {}: version {} at offset {} (supported: {})", kBrushListLump, version,
                             offset, kBrushListVersion);
    std::size_t counted = 0;
    model.brushes.reserve(brushes);
    for (std::uint32_t i = 0; i < brushes; ++i) {
      if (reader.remaining() < kBrushBytes) return cut_off(reader);
      TRY(ListedBrush brush, read_listed_brush(reader));
      counted += brush.planes.size();
      model.brushes.push_back(std::move(brush));
    }
    if (counted != planes)
      return base::malformed("lump {}: model {} has {} planes, but announces {}", kBrushListLump, model.model,
                             counted, planes);
  }
  return models;
}

base::ByteVector write_brush_list(std::span<const ListedModel> models) {
  base::ByteWriter writer;
  for (const ListedModel& model : models) {
    std::size_t planes = 0;
    for (const ListedBrush& brush : model.brushes) planes += brush.planes.size();
    writer.u32(kBrushListVersion);
    writer.u32(model.model);
    writer.u32(static_cast<std::uint32_t>(model.brushes.size()));
    writer.u32(static_cast<std::uint32_t>(planes));
    for (const ListedBrush& brush : model.brushes) {
      CHECK(brush.planes.size() <= std::numeric_limits<std::uint16_t>::max());
      write_corner(brush.mins, writer);
      write_corner(brush.maxs, writer);
      writer.i16(brush.contents);
      writer.u16(static_cast<std::uint16_t>(brush.planes.size()));
      for (const ListedPlane& plane : brush.planes) {
        write_corner(plane.normal, writer);
        writer.f32(plane.distance);
      }
    }
  }
  return std::move(writer).take();
}

}  // namespace temblor::formats
