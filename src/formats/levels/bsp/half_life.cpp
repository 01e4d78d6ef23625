#include "formats/levels/bsp/half_life.h"

#include <limits>
#include <span>
#include <utility>

namespace temblor::formats::bsp_file {
namespace {

constexpr std::string_view kLightLump = "RGBLIGHTING";
constexpr std::size_t kColorBytes = 3;
constexpr std::int32_t kNoLight = -1;

// The brightness that the eye sees (ITU-R BT.601), in 256ths. Equal parts give themselves.
std::uint8_t find_gray(std::span<const std::uint8_t> color) {
  return static_cast<std::uint8_t>((color[0] * 77 + color[1] * 150 + color[2] * 29) / 256);
}

}  // namespace

void separate_gray_light(Bsp& io_bsp) {
  const std::vector<std::uint8_t> colors = std::move(io_bsp.lighting);
  const std::size_t samples = colors.size() / kColorBytes;
  io_bsp.lighting.assign(samples, 0);
  for (std::size_t i = 0; i < samples; ++i)
    io_bsp.lighting[i] = find_gray(std::span(colors).subspan(i * kColorBytes, kColorBytes));
  for (BspFace& face : io_bsp.faces) {
    if (face.light_offset < 0) continue;
    const auto bytes = static_cast<std::int32_t>(kColorBytes);
    face.light_offset = face.light_offset % bytes == 0 ? face.light_offset / bytes : kNoLight;
  }
  io_bsp.bspx = lumps_without_light(std::move(io_bsp.bspx));
  if (samples == 0) return;
  const base::Bytes whole = std::as_bytes(std::span(colors)).first(samples * kColorBytes);
  io_bsp.bspx.insert(io_bsp.bspx.begin(),
                     {std::string(kLightLump), base::ByteVector(whole.begin(), whole.end())});
}

base::ByteVector colored_light(const Bsp& bsp) {
  const BspxLump* lump = bsp.find_bspx(kLightLump);
  if (lump != nullptr && lump->data.size() == kColorBytes * bsp.lighting.size()) return lump->data;
  base::ByteVector colors;
  colors.reserve(kColorBytes * bsp.lighting.size());
  for (const std::uint8_t sample : bsp.lighting) colors.insert(colors.end(), kColorBytes, std::byte{sample});
  return colors;
}

base::Result<std::vector<BspFace>> count_light_bytes(std::vector<BspFace> faces) {
  constexpr auto kBytes = static_cast<std::int32_t>(kColorBytes);
  for (std::size_t i = 0; i < faces.size(); ++i) {
    std::int32_t& offset = faces[i].light_offset;
    if (offset < 0) continue;
    if (offset > std::numeric_limits<std::int32_t>::max() / kBytes)
      return error(base::ErrorCode::kTooLarge, "lump faces: face {}: light offset {} does not fit version 30",
                   i, offset);
    offset *= kBytes;
  }
  return faces;
}

std::vector<BspxLump> lumps_without_light(std::vector<BspxLump> lumps) {
  std::erase_if(lumps, [](const BspxLump& lump) { return lump.name == kLightLump; });
  return lumps;
}

}  // namespace temblor::formats::bsp_file
