#include "formats/levels/decoupled_light.h"

#include <cmath>
#include <string_view>

#include "base/bytes.h"
#include "formats/levels/bsp_validate.h"

namespace temblor::formats {
namespace {

constexpr std::string_view kDecoupledLump = "DECOUPLED_LM";
constexpr std::size_t kDecoupledBytes = 40;

DecoupledLightMap read_decoupled_map(base::ByteReader& io_reader) {
  DecoupledLightMap map;
  map.width = io_reader.u16();
  map.height = io_reader.u16();
  map.offset = io_reader.i32();
  const auto read_row = [&](math::Vec3& out_axis, float& out_offset) {
    for (int axis = 0; axis < 3; ++axis) out_axis[axis] = io_reader.f32();
    out_offset = io_reader.f32();
  };
  read_row(map.x_axis, map.x_offset);
  read_row(map.y_axis, map.y_offset);
  return map;
}

// Whether all numbers are finite and within the range of a level's coordinates.
bool has_sane_numbers(const DecoupledLightMap& map) {
  for (const float number : {map.x_axis.x, map.x_axis.y, map.x_axis.z, map.x_offset, map.y_axis.x,
                             map.y_axis.y, map.y_axis.z, map.y_offset})
    if (!(std::abs(number) <= kBspMaxCoordinate)) return false;
  return true;
}

}  // namespace

base::Result<std::vector<DecoupledLightMap>> read_decoupled_light(const Bsp& bsp) {
  std::vector<DecoupledLightMap> maps;
  const BspxLump* lump = bsp.find_bspx(kDecoupledLump);
  if (lump == nullptr) return maps;
  if (lump->data.size() != bsp.faces.size() * kDecoupledBytes)
    return base::malformed("lump {}: {} bytes, but {} faces need {}", kDecoupledLump, lump->data.size(),
                           bsp.faces.size(), bsp.faces.size() * kDecoupledBytes);
  base::ByteReader reader(lump->data);
  maps.reserve(bsp.faces.size());
  for (std::size_t face = 0; face < bsp.faces.size(); ++face) {
    const DecoupledLightMap map = read_decoupled_map(reader);
    if (map.offset < -1)
      return base::malformed("lump {}: face {} has offset {}", kDecoupledLump, face, map.offset);
    if (map.offset >= 0 && !has_sane_numbers(map))
      return base::malformed("lump {}: face {} has axes or offsets that are not finite or too large",
                             kDecoupledLump, face);
    maps.push_back(map);
  }
  return maps;
}

void set_decoupled_light(std::span<const DecoupledLightMap> maps, Bsp& io_bsp) {
  std::erase_if(io_bsp.bspx, [](const BspxLump& lump) { return lump.name == kDecoupledLump; });
  if (maps.empty()) return;
  base::ByteWriter writer;
  for (const DecoupledLightMap& map : maps) {
    writer.u16(map.width);
    writer.u16(map.height);
    writer.i32(map.offset);
    for (int axis = 0; axis < 3; ++axis) writer.f32(map.x_axis[axis]);
    writer.f32(map.x_offset);
    for (int axis = 0; axis < 3; ++axis) writer.f32(map.y_axis[axis]);
    writer.f32(map.y_offset);
  }
  io_bsp.bspx.push_back({std::string(kDecoupledLump), std::move(writer).take()});
}

}  // namespace temblor::formats
