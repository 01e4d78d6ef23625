#include "formats/images/wad_texture.h"

#include <span>

#include "base/text.h"
#include "formats/archives/wad.h"

namespace temblor::formats {
namespace {

constexpr std::size_t kMiptexHeaderBytes = 40;

bool is_miptex_side(std::uint32_t side) {
  return side >= 1 && side <= kMaxTextureSide;
}

std::size_t mip_texels(std::uint32_t width, std::uint32_t height, std::size_t level) {
  return std::size_t{width >> level} * (height >> level);
}

}  // namespace

std::vector<std::uint8_t> sample_mip(std::span<const std::uint8_t> mip0, std::uint32_t width,
                                     std::uint32_t height, std::size_t level) {
  std::vector<std::uint8_t> texels;
  texels.reserve(mip_texels(width, height, level));
  for (std::size_t y = 0; y < height >> level; ++y)
    for (std::size_t x = 0; x < width >> level; ++x)
      texels.push_back(mip0[(y << level) * width + (x << level)]);
  return texels;
}

base::Result<WadTexture> read_wad_texture(base::Bytes lump) {
  base::ByteReader reader(lump);
  WadTexture texture;
  texture.name = reader.fixed_text(kWadNameChars);
  texture.width = reader.u32();
  texture.height = reader.u32();
  std::array<std::uint32_t, 4> offsets{};
  for (std::uint32_t& offset : offsets) offset = reader.u32();
  if (!reader.ok())
    return base::malformed("texture header needs {} bytes, the lump has {}", kMiptexHeaderBytes, lump.size());
  if (!is_miptex_side(texture.width) || !is_miptex_side(texture.height))
    return base::malformed("texture \"{}\": {} x {} texels, sides are 1 to {}", base::printable(texture.name),
                           texture.width, texture.height, kMaxTextureSide);
  for (std::size_t level = 0; level < offsets.size(); ++level) {
    const std::size_t texels = mip_texels(texture.width, texture.height, level);
    const bool is_inside = offsets[level] >= kMiptexHeaderBytes && offsets[level] <= lump.size() &&
                           texels <= lump.size() - offsets[level];
    if (!is_inside && level == 0)
      return base::malformed("texture \"{}\": mip 0 at offset {} with {} texels lies outside of its {} bytes",
                             base::printable(texture.name), offsets[level], texels, lump.size());
    if (!is_inside) {
      texture.mips[level] = sample_mip(texture.mips[0], texture.width, texture.height, level);
      continue;
    }
    const auto mip = base::as_u8(lump.subspan(offsets[level], texels));
    texture.mips[level].assign(mip.begin(), mip.end());
  }
  return texture;
}

base::Result<base::ByteVector> write_wad_texture(const WadTexture& texture) {
  if (!is_miptex_side(texture.width) || !is_miptex_side(texture.height))
    return base::error(base::ErrorCode::kUsage, "texture \"{}\": {} x {} texels, sides are 1 to {}",
                       texture.name, texture.width, texture.height, kMaxTextureSide);
  if (texture.name.size() > kWadNameChars)
    return base::error(base::ErrorCode::kTooLarge, "\"{}\": texture names have at most {} characters",
                       texture.name, kWadNameChars);
  base::ByteWriter writer;
  writer.fixed_text(texture.name, kWadNameChars);
  writer.u32(texture.width);
  writer.u32(texture.height);
  std::size_t offset = kMiptexHeaderBytes;
  for (std::size_t level = 0; level < texture.mips.size(); ++level) {
    CHECK(texture.mips[level].size() == mip_texels(texture.width, texture.height, level), "mip {}", level);
    writer.u32(static_cast<std::uint32_t>(offset));
    offset += texture.mips[level].size();
  }
  for (const std::vector<std::uint8_t>& mip : texture.mips) writer.bytes(std::as_bytes(std::span(mip)));
  return std::move(writer).take();
}

}  // namespace temblor::formats
