#include "formats/bspx/face_normals.h"

#include <algorithm>

#include "base/bytes.h"

namespace temblor::formats {
namespace {

constexpr std::size_t kVectorBytes = 12, kCornerBytes = 12;

}  // namespace

base::Result<FaceNormals> read_face_normals(const Bsp& bsp) {
  FaceNormals normals;
  const BspxLump* const lump = bsp.find_bspx(kFaceNormalsLump);
  if (lump == nullptr) return normals;
  std::size_t corners = 0;
  for (const BspFace& face : bsp.faces) corners += face.surfedge_count;
  base::ByteReader reader(lump->data);
  const std::size_t count = reader.u32();
  if (!reader.ok() || count > reader.remaining() / kVectorBytes ||
      reader.remaining() - count * kVectorBytes != corners * kCornerBytes)
    return base::malformed("lump {}: {} bytes do not fit {} vectors and {} corners of faces", lump->name,
                           lump->data.size(), count, corners);
  normals.vectors.resize(count);
  for (math::Vec3& vector : normals.vectors)
    for (int axis = 0; axis < 3; ++axis) vector[axis] = reader.f32();
  normals.corners.resize(corners);
  for (std::size_t i = 0; i < corners; ++i) {
    CornerVectors& corner = normals.corners[i];
    corner = {reader.u32(), reader.u32(), reader.u32()};
    if (std::max({corner.normal, corner.tangent, corner.bitangent}) >= count)
      return base::malformed("lump {}: corner {} names a vector past the last of {}", lump->name, i, count);
  }
  return normals;
}

void set_face_normals(const FaceNormals& normals, Bsp& io_bsp) {
  std::erase_if(io_bsp.bspx, [](const BspxLump& lump) { return lump.name == kFaceNormalsLump; });
  base::ByteWriter writer;
  writer.u32(static_cast<std::uint32_t>(normals.vectors.size()));
  for (const math::Vec3& vector : normals.vectors)
    for (int axis = 0; axis < 3; ++axis) writer.f32(vector[axis]);
  for (const CornerVectors& corner : normals.corners)
    for (const std::uint32_t number : {corner.normal, corner.tangent, corner.bitangent}) writer.u32(number);
  io_bsp.bspx.push_back({kFaceNormalsLump, std::move(writer).take()});
}

}  // namespace temblor::formats
