#include "formats/levels/bsp/textures.h"

#include <algorithm>
#include <limits>

#include "formats/images/wad_texture.h"
#include "formats/levels/bsp_validate.h"

namespace temblor::formats::bsp_file {
namespace {

constexpr std::size_t kMiptexNameBytes = 16;
constexpr std::size_t kTextureHeaderBytes = kMiptexNameBytes + 6 * 4;
constexpr std::int32_t kNotPresent = -1;
constexpr std::uint32_t kSomeTextureSize = 16;
constexpr std::size_t kMaxOwnColors = 256;

bool is_texture_size(std::uint32_t size) {
  return size >= 1 && size <= kBspMaxTextureSize;
}

std::size_t mip_bytes(const BspMiptex& texture, std::size_t mip) {
  return std::size_t{texture.width >> mip} * (texture.height >> mip);
}

// A texture without mip levels, whose faces are drawn as a checkerboard.
BspMiptex make_without_texels(std::string name, std::uint32_t width, std::uint32_t height) {
  BspMiptex texture;
  texture.present = true;
  texture.name = std::move(name);
  texture.width = is_texture_size(width) ? width : kSomeTextureSize;
  texture.height = is_texture_size(height) ? height : kSomeTextureSize;
  return texture;
}

// Returns no colors if they are not inside of the lump.
std::vector<Rgb> read_own_palette(base::Bytes lump, std::size_t offset) {
  base::ByteReader reader(lump);
  reader.seek(offset);
  const std::size_t count = reader.u16();
  if (!reader.ok() || count > kMaxOwnColors || reader.remaining() < 3 * count) return {};
  std::vector<Rgb> palette(count);
  for (Rgb& color : palette) {
    color.r = reader.u8();
    color.g = reader.u8();
    color.b = reader.u8();
  }
  return palette;
}

// Reads one texture. `io_budget_bytes`: the remaining limit for the total size of all textures, so that many
// textures that share the same texels cannot exhaust memory.
BspMiptex read_texture(base::Bytes lump, std::size_t offset, BspVersion version,
                       std::size_t& io_budget_bytes) {
  base::ByteReader reader(lump);
  reader.seek(offset);
  std::string name = reader.fixed_text(kMiptexNameBytes).substr(0, kMiptexNameBytes - 1);
  const std::uint32_t width = reader.u32(), height = reader.u32();
  std::array<std::uint32_t, 4> mip_offsets{};
  for (std::uint32_t& mip_offset : mip_offsets) mip_offset = reader.u32();
  if (!reader.ok()) return {};

  BspMiptex texture = make_without_texels(std::move(name), width, height);
  if (texture.width != width || texture.height != height) return texture;
  for (std::size_t mip = 0; mip < 4; ++mip) {
    const std::size_t begin = offset + mip_offsets[mip], size = mip_bytes(texture, mip);
    const bool is_inside = mip_offsets[mip] >= kTextureHeaderBytes && begin <= lump.size() &&
                           size <= std::min(lump.size() - begin, io_budget_bytes);
    if (!is_inside && mip == 0) return texture;
    if (!is_inside) {
      texture.mips[mip] = sample_mip(texture.mips[0], width, height, mip);
      continue;
    }
    io_budget_bytes -= size;
    const auto texels = base::as_u8(lump.subspan(begin, size));
    texture.mips[mip].assign(texels.begin(), texels.end());
  }
  if (version == BspVersion::k30)
    texture.palette = read_own_palette(lump, offset + mip_offsets[3] + mip_bytes(texture, 3));
  return texture;
}

base::Status write_texture(base::ByteWriter& writer, const BspMiptex& texture, BspVersion version) {
  if (texture.name.size() >= kMiptexNameBytes)
    return error(base::ErrorCode::kTooLarge, "its name \"{}\" is longer than {} characters", texture.name,
                 kMiptexNameBytes - 1);
  writer.fixed_text(texture.name, kMiptexNameBytes);
  writer.u32(texture.width);
  writer.u32(texture.height);
  const bool is_external = std::ranges::all_of(texture.mips, [](const auto& mip) { return mip.empty(); });
  std::size_t mip_offset = kTextureHeaderBytes;
  for (const auto& mip : texture.mips) {
    writer.u32(is_external ? 0 : static_cast<std::uint32_t>(mip_offset));
    mip_offset += mip.size();
  }
  for (const auto& mip : texture.mips) writer.bytes(std::as_bytes(std::span(mip)));
  if (version != BspVersion::k30 || is_external) return base::Ok{};
  writer.u16(static_cast<std::uint16_t>(texture.palette.size()));
  for (const Rgb& color : texture.palette)
    for (const std::uint8_t part : {color.r, color.g, color.b}) writer.u8(part);
  return base::Ok{};
}

}  // namespace

std::vector<BspMiptex> read_textures(base::Bytes lump, BspVersion version) {
  std::vector<BspMiptex> textures;
  if (lump.empty()) return textures;
  base::ByteReader reader(lump);
  const auto count = static_cast<std::uint32_t>(std::min<std::size_t>(reader.u32(), reader.remaining() / 4));
  textures.reserve(count);
  std::size_t budget_bytes = lump.size();
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::int32_t offset = reader.i32();
    // Any other negative offset becomes a huge one, where no header is.
    textures.push_back(offset == kNotPresent
                           ? BspMiptex{}
                           : read_texture(lump, static_cast<std::uint32_t>(offset), version, budget_bytes));
  }
  return textures;
}

base::Status write_textures(base::ByteWriter& writer, const std::vector<BspMiptex>& textures,
                            BspVersion version) {
  const std::size_t lump_begin = writer.size();
  writer.u32(static_cast<std::uint32_t>(textures.size()));
  const std::size_t table = writer.size();
  for (std::size_t i = 0; i < textures.size(); ++i) writer.i32(kNotPresent);
  for (std::size_t i = 0; i < textures.size(); ++i) {
    if (!textures[i].present) continue;
    writer.align(4);
    writer.patch(table + 4 * i, static_cast<std::uint32_t>(writer.size() - lump_begin));
    if (auto status = write_texture(writer, textures[i], version); !status)
      return error(status.error().code, "lump textures: texture {}: {}", i, status.error().what);
  }
  return base::Ok{};
}

}  // namespace temblor::formats::bsp_file
