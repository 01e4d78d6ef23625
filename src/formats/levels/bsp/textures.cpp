#include "formats/levels/bsp/textures.h"

#include <algorithm>
#include <limits>

#include "formats/levels/bsp_validate.h"

namespace temblor::formats::bsp_file {
namespace {

constexpr std::size_t kMiptexNameBytes = 16;
constexpr std::size_t kTextureHeaderBytes = kMiptexNameBytes + 6 * 4;
constexpr std::int32_t kNotPresent = -1;

bool is_texture_size(std::uint32_t size) {
  return size >= 1 && size <= kBspMaxTextureSize;
}

std::size_t mip_bytes(const BspMiptex& texture, std::size_t mip) {
  return std::size_t{texture.width >> mip} * (texture.height >> mip);
}

// Reads one texture. `io_budget_bytes`: the remaining limit for the total size of all textures, so that many
// textures that share the same texels cannot exhaust memory.
base::Result<BspMiptex> read_texture(base::Bytes lump, std::size_t offset, std::size_t& io_budget_bytes) {
  base::ByteReader reader(lump);
  reader.seek(offset);
  BspMiptex texture;
  texture.present = true;
  texture.name = reader.fixed_text(kMiptexNameBytes).substr(0, kMiptexNameBytes - 1);
  texture.width = reader.u32();
  texture.height = reader.u32();
  std::array<std::uint32_t, 4> mip_offsets{};
  for (std::uint32_t& mip_offset : mip_offsets) mip_offset = reader.u32();
  if (!reader.ok()) return base::malformed("its header reaches past the end of the lump");
  if (!is_texture_size(texture.width) || !is_texture_size(texture.height))
    return base::malformed("size {} x {} is not within 1 to {}", texture.width, texture.height,
                           kBspMaxTextureSize);
  if (mip_offsets == std::array<std::uint32_t, 4>{}) return texture;

  for (std::size_t mip = 0; mip < 4; ++mip) {
    const std::size_t begin = offset + mip_offsets[mip], size = mip_bytes(texture, mip);
    if (mip_offsets[mip] < kTextureHeaderBytes || begin > lump.size() || size > lump.size() - begin)
      return base::malformed("mip level {} ({} x {} at {:#x} from the texture's start) lies outside its data",
                             mip, texture.width >> mip, texture.height >> mip, mip_offsets[mip]);
    if (size > io_budget_bytes)
      return base::malformed("textures overlap: together they are larger than the lump");
    io_budget_bytes -= size;
    const auto texels = base::as_u8(lump.subspan(begin, size));
    texture.mips[mip].assign(texels.begin(), texels.end());
  }
  return texture;
}

base::Status write_texture(base::ByteWriter& writer, const BspMiptex& texture) {
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
  return base::Ok{};
}

}  // namespace

base::Result<Textures> read_textures(base::Bytes lump, std::size_t lump_offset) {
  Textures result;
  std::vector<BspMiptex>& textures = result.textures;
  if (lump.empty()) return result;
  base::ByteReader reader(lump);
  const std::uint32_t count = reader.u32();
  if (!reader.ok() || count > reader.remaining() / 4)
    return base::malformed("lump textures: {} textures do not fit into {} bytes", count, lump.size());

  textures.reserve(count);
  std::size_t budget_bytes = lump.size();
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::int32_t offset = reader.i32();
    if (offset == kNotPresent) {
      textures.emplace_back();
      continue;
    }
    // A negative offset becomes a huge one, which read_texture() rejects.
    auto texture = read_texture(lump, static_cast<std::uint32_t>(offset), budget_bytes);
    if (!texture) {
      base::Error error =
          base::malformed("lump textures: texture {} at offset {:#x}: {}", i,
                          lump_offset + static_cast<std::uint32_t>(offset), texture.error().what);
      if (result.damaged.size() >= kMaxDamagedTextures) return error;
      result.damaged.push_back({i, std::move(error)});
    }
    textures.push_back(texture ? std::move(texture).value() : BspMiptex{});
  }
  return result;
}

base::Status write_textures(base::ByteWriter& writer, const std::vector<BspMiptex>& textures) {
  const std::size_t lump_begin = writer.size();
  writer.u32(static_cast<std::uint32_t>(textures.size()));
  const std::size_t table = writer.size();
  for (std::size_t i = 0; i < textures.size(); ++i) writer.i32(kNotPresent);
  for (std::size_t i = 0; i < textures.size(); ++i) {
    if (!textures[i].present) continue;
    writer.align(4);
    writer.patch(table + 4 * i, static_cast<std::uint32_t>(writer.size() - lump_begin));
    if (auto status = write_texture(writer, textures[i]); !status)
      return error(status.error().code, "lump textures: texture {}: {}", i, status.error().what);
  }
  return base::Ok{};
}

}  // namespace temblor::formats::bsp_file
