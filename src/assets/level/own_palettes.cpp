#include "assets/level/own_palettes.h"

#include <algorithm>
#include <optional>

#include "formats/images/build_mips.h"
#include "formats/images/colored_texture.h"

namespace temblor::assets {

void add_own_palettes(const formats::Palette& game_palette, const formats::Bsp& bsp,
                      world::ColoredTextures& io_textures) {
  std::optional<formats::MipColors> mip_colors;  // most levels need none
  io_textures.resize(std::max(io_textures.size(), bsp.miptexes.size()));
  for (std::size_t i = 0; i < bsp.miptexes.size(); ++i) {
    const formats::BspMiptex& miptex = bsp.miptexes[i];
    const std::size_t texels = std::size_t{miptex.width} * miptex.height;
    if (miptex.palette.empty() || io_textures[i] || texels == 0 || miptex.mips[0].size() != texels) continue;
    formats::Palette own{};
    std::ranges::copy(miptex.palette, own.begin());
    if (own == game_palette) continue;
    if (!mip_colors) mip_colors.emplace(game_palette);
    io_textures[i] = formats::make_colored_texture(
        {miptex.width, miptex.height, miptex.name.starts_with('{')}, miptex.mips[0], own, *mip_colors);
  }
}

}  // namespace temblor::assets
