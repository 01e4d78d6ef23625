#include "formats/images/wad3_texture.h"

#include <algorithm>
#include <span>

#include "base/text.h"

namespace temblor::formats {
namespace {

// Returns the fullbright colors, without the last one, which is transparent.
std::span<const Rgb> fullbright_colors(const Palette& palette) {
  return std::span(palette).subspan(kFirstFullbright, kTransparentIndex - kFirstFullbright);
}

// Maps the texture's palette indices to those of the game.
using IndexTable = std::array<std::uint8_t, 256>;

IndexTable make_table(const Wad3Texture& texture, const Palette& game_palette,
                      const NearestColor& dull_colors) {
  const bool means_fullbrights =
      std::ranges::equal(fullbright_colors(texture.palette), fullbright_colors(game_palette));
  IndexTable table{};
  for (std::size_t i = 0; i < table.size(); ++i)
    table[i] = means_fullbrights && i >= kFirstFullbright ? static_cast<std::uint8_t>(i)
                                                          : dull_colors.find(texture.palette[i]);
  if (texture.texture.name.starts_with('{')) table[kTransparentIndex] = kTransparentIndex;
  return table;
}

}  // namespace

base::Result<Wad3Texture> read_wad3_texture(base::Bytes lump) {
  Wad3Texture texture;
  TRY(texture.texture, read_wad_texture(lump));
  base::ByteReader reader(lump);
  constexpr std::size_t kLastOffset = 36;
  reader.seek(kLastOffset);
  reader.seek(reader.u32() + texture.texture.mips.back().size());
  const std::uint16_t colors = reader.u16();
  if (!reader.ok() || colors > texture.palette.size() || reader.remaining() < std::size_t{colors} * 3)
    return base::malformed("texture \"{}\": no palette of up to 256 colors after the mip levels",
                           base::printable(texture.texture.name));
  for (Rgb& color : std::span(texture.palette).first(colors)) {
    color.r = reader.u8();
    color.g = reader.u8();
    color.b = reader.u8();
  }
  return texture;
}

base::Result<base::ByteVector> write_wad3_texture(const Wad3Texture& texture) {
  TRY(const base::ByteVector mips, write_wad_texture(texture.texture));
  std::size_t colors = 0;
  for (const auto& mip : texture.texture.mips)
    for (const std::uint8_t index : mip) colors = std::max(colors, std::size_t{index} + 1);
  base::ByteWriter writer;
  writer.bytes(mips);
  writer.u16(static_cast<std::uint16_t>(colors));
  for (const Rgb& color : std::span(texture.palette).first(colors)) {
    writer.u8(color.r);
    writer.u8(color.g);
    writer.u8(color.b);
  }
  return std::move(writer).take();
}

WadTexture convert_to_palette(const Wad3Texture& texture, const Palette& game_palette,
                              const NearestColor& dull_colors) {
  const IndexTable table = make_table(texture, game_palette, dull_colors);
  WadTexture result = texture.texture;
  for (auto& mip : result.mips)
    for (std::uint8_t& index : mip) index = table[index];
  return result;
}

}  // namespace temblor::formats
