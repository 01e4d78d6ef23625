#include "formats/levels/scaled_light.h"

#include <algorithm>
#include <string_view>

#include "base/bytes.h"

namespace temblor::formats {
namespace {

constexpr std::string_view kShiftsLump = "LMSHIFT", kOffsetsLump = "LMOFFSET", kStylesLump = "LMSTYLE",
                           kWideStylesLump = "LMSTYLE16";
constexpr std::uint16_t kUnusedWideStyle = 65535;

// Fails if the lump does not have `bytes_per_face` bytes for each face.
base::Status check_lump_size(const BspxLump& lump, std::size_t bytes_per_face, std::size_t faces) {
  if (lump.data.size() == bytes_per_face * faces) return base::Ok{};
  return base::malformed("lump {}: {} bytes, but {} faces need {}", lump.name, lump.data.size(), faces,
                         bytes_per_face * faces);
}

base::Result<std::vector<FaceStyles>> read_wide_styles(const BspxLump& lump, std::size_t faces) {
  const std::size_t bytes_per_face = faces == 0 ? 0 : lump.data.size() / faces;
  if (bytes_per_face < 2 || bytes_per_face % 2 != 0 || lump.data.size() % faces != 0)
    return base::malformed("lump {}: {} bytes are not a whole number of styles for each of {} faces",
                           lump.name, lump.data.size(), faces);
  std::vector<FaceStyles> styles(faces, ScaledLightMap{}.styles);
  base::ByteReader reader(lump.data);
  for (std::size_t face = 0; face < faces; ++face)
    for (std::size_t i = 0; i < bytes_per_face / 2; ++i) {
      const std::uint16_t style = reader.u16();
      if (i >= styles[face].size() || style == kUnusedWideStyle) continue;
      if (style >= 255) return base::malformed("lump {}: face {} has light style {}", lump.name, face, style);
      styles[face][i] = static_cast<std::uint8_t>(style);
    }
  return styles;
}

}  // namespace

base::Result<std::vector<FaceStyles>> read_face_styles(const Bsp& bsp) {
  const std::size_t faces = bsp.faces.size();
  if (const BspxLump* wide = bsp.find_bspx(kWideStylesLump)) return read_wide_styles(*wide, faces);
  std::vector<FaceStyles> styles;
  styles.reserve(faces);
  if (const BspxLump* lump = bsp.find_bspx(kStylesLump)) {
    TRY_STATUS(check_lump_size(*lump, sizeof(FaceStyles), faces));
    base::ByteReader reader(lump->data);
    for (std::size_t face = 0; face < faces; ++face)
      for (std::uint8_t& style : styles.emplace_back()) style = reader.u8();
  } else {
    for (const BspFace& face : bsp.faces) styles.push_back(face.styles);
  }
  return styles;
}

base::Result<std::vector<ScaledLightMap>> read_scaled_light(const Bsp& bsp) {
  std::vector<ScaledLightMap> maps;
  const BspxLump* shifts = bsp.find_bspx(kShiftsLump);
  if (shifts == nullptr) return maps;
  TRY_STATUS(check_lump_size(*shifts, 1, bsp.faces.size()));
  const BspxLump* offsets = bsp.find_bspx(kOffsetsLump);
  if (offsets != nullptr) TRY_STATUS(check_lump_size(*offsets, sizeof(std::int32_t), bsp.faces.size()));
  TRY(const std::vector<FaceStyles> styles, read_face_styles(bsp));
  base::ByteReader shift_reader(shifts->data);
  base::ByteReader offset_reader(offsets != nullptr ? base::Bytes(offsets->data) : base::Bytes{});
  maps.reserve(bsp.faces.size());
  for (std::size_t face = 0; face < bsp.faces.size(); ++face) {
    const std::uint8_t shift = shift_reader.u8();
    const std::int32_t offset = offsets != nullptr ? offset_reader.i32() : bsp.faces[face].light_offset;
    if (shift > kMaxLightShift)
      return base::malformed("lump {}: face {} has shift {}, but the highest is {}", kShiftsLump, face, shift,
                             kMaxLightShift);
    if (offset < -1) return base::malformed("lump {}: face {} has offset {}", kOffsetsLump, face, offset);
    maps.push_back({shift, offset, styles[face]});
  }
  return maps;
}

void set_face_styles(std::span<const FaceStyles> styles, Bsp& io_bsp) {
  std::erase_if(io_bsp.bspx, [](const BspxLump& lump) {
    return lump.name == kStylesLump || lump.name == kWideStylesLump;
  });
  if (std::ranges::equal(styles, io_bsp.faces, {}, {}, &BspFace::styles)) return;
  base::ByteWriter writer;
  for (const FaceStyles& face : styles) writer.bytes(std::as_bytes(std::span(face)));
  io_bsp.bspx.push_back({std::string(kStylesLump), std::move(writer).take()});
}

void set_scaled_light(std::span<const ScaledLightMap> maps, Bsp& io_bsp) {
  std::erase_if(io_bsp.bspx, [](const BspxLump& lump) {
    return lump.name == kShiftsLump || lump.name == kOffsetsLump || lump.name == kStylesLump ||
           lump.name == kWideStylesLump;
  });
  if (maps.empty()) return;
  base::ByteWriter shifts, offsets, styles;
  for (const ScaledLightMap& map : maps) {
    shifts.u8(map.shift);
    offsets.i32(map.offset);
    styles.bytes(std::as_bytes(std::span(map.styles)));
  }
  io_bsp.bspx.push_back({std::string(kShiftsLump), std::move(shifts).take()});
  io_bsp.bspx.push_back({std::string(kOffsetsLump), std::move(offsets).take()});
  io_bsp.bspx.push_back({std::string(kStylesLump), std::move(styles).take()});
}

}  // namespace temblor::formats
