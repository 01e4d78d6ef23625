// Textures that are not drawn in the colors of the game's palette: those with a palette of their own, and
// pictures in files that replace a level's textures. Each is made in both forms that the renderer needs,
// once: colors for 32-bit frames, and the nearest palette entries for 256-color frames.
//
// A picture may have more texels than the texture that it replaces. It is then also kept in *fine* mip
// levels, which continue the four usual ones downward:
//
//   mip    -2           -1           0          1           2           3
//   size   4w x 4h      2w x 2h      w x h      w/2 x h/2   w/4 x h/4   w/8 x h/8
//
// Each level is the mean of the level before in linear light (the square of a channel), as in build_mips.h:
// means of plain values are too dark, so walls would change their brightness with the distance. Palette
// entries are matched with error diffusion (Floyd and Steinberg, "An Adaptive Algorithm for Spatial
// Grayscale", 1976).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "formats/images/build_mips.h"
#include "formats/images/image.h"
#include "formats/images/palette.h"

namespace temblor::formats {

// A picture is reduced to at most 2^kMaxTextureDetail times the width and height of its texture: 8 texels per
// unit on usual walls are more than a pixel's width at 170 units in a view of 1920 pixels.
constexpr int kMaxTextureDetail = 3;

// The colors of a texture, besides its palette indices. All levels are row by row.
struct TextureColors {
  int detail = 0;  // the number of fine mip levels
  // Mip -1, -2, ... -detail: palette indices.
  std::vector<std::vector<std::uint8_t>> fine_indices;
  // Mip -detail to 3: 0xffRRGGBB, or 0 where the texture is clear.
  std::vector<std::vector<std::uint32_t>> colors;
  // The same levels of the color that the texture emits, added to the lit color: 0x00RRGGBB. Empty: none.
  std::vector<std::vector<std::uint32_t>> glow;
};

struct ColoredTexture {
  // Mip 0 to 3, as in Miptex: max(1, width >> mip) x max(1, height >> mip) palette indices. 255 is clear.
  std::array<std::vector<std::uint8_t>, 4> mips;
  TextureColors colors;
};

// The memory that the texels take.
std::size_t count_bytes(const ColoredTexture& texture);

// The texture that a picture is for. Its coordinates count in texels of its own size, so a larger picture has
// more texels per unit.
struct TextureFrame {
  std::uint32_t width = 1, height = 1;  // at least 1
  // Texels with an alpha below 128 are clear. False: alpha is ignored.
  bool has_holes = false;
};

// Fits `picture` to the frame; sizes that are not the frame's times a power of two are resampled. `glow` is
// another picture of any size, or empty (0 x 0). In palette indices a texel becomes full-bright where its
// glow is brighter than its color, and never otherwise.
ColoredTexture make_colored_texture(const TextureFrame& frame, Image picture, const Image& glow,
                                    const MipColors& colors);

// A texture with a palette of its own: frame.width * frame.height indices (CHECKed). With has_holes, index
// 255 is clear.
ColoredTexture make_colored_texture(const TextureFrame& frame, std::span<const std::uint8_t> indices,
                                    const Palette& own_palette, const MipColors& colors);

}  // namespace temblor::formats
