#include "render/surfaces/cutout_textures.h"

#include <algorithm>
#include <array>

namespace temblor::render {

namespace {

// The texels of mip 0 under one texel of a mip level.
struct Block {
  int texels = 0, opaque = 0;
  std::uint8_t mean = kClearIndex;  // of the opaque texels
};

// The mean color of opaque texels. Full-bright texels are not mixed with others: the more numerous kind wins.
class OpaqueMean {
 public:
  void add(formats::Rgb color, bool fullbright) {
    Sum& sum = sums_[fullbright];
    ++sum.count;
    sum.r += color.r;
    sum.g += color.g;
    sum.b += color.b;
  }
  int count() const { return sums_[0].count + sums_[1].count; }
  std::uint8_t match(const PaletteMatch& match) const {
    const bool fullbright = sums_[1].count > sums_[0].count;
    const Sum& sum = sums_[fullbright];
    const auto mean = [&](int total) {
      return static_cast<std::uint8_t>((total + sum.count / 2) / sum.count);
    };
    return match({mean(sum.r), mean(sum.g), mean(sum.b)}, fullbright);
  }

 private:
  struct Sum {
    int count = 0, r = 0, g = 0, b = 0;
  };
  std::array<Sum, 2> sums_;
};

Block block_at(const world::Texture& texture, std::uint32_t x, std::uint32_t y, unsigned mip,
               const ColorTables& tables) {
  const std::uint32_t right = std::min((x + 1) << mip, texture.width);
  const std::uint32_t bottom = std::min((y + 1) << mip, texture.height);
  Block block;
  OpaqueMean mean;
  for (std::uint32_t row = y << mip; row < bottom; ++row)
    for (std::uint32_t column = x << mip; column < right; ++column) {
      const std::uint8_t index = texture.mips[0][std::size_t{row} * texture.width + column];
      ++block.texels;
      if (index != kClearIndex) mean.add(tables.palette[index], tables.match.is_fullbright(index));
    }
  block.opaque = mean.count();
  if (block.opaque > 0) block.mean = mean.match(tables.match);
  return block;
}

// Error diffusion (Floyd and Steinberg, 1976): the difference between a texel's opacity (0 or 1) and its
// block's opaque share is passed on to the texels after it. A block that is completely clear stays clear.
std::vector<std::uint8_t> make_mip(const world::Texture& texture, unsigned mip, const ColorTables& tables) {
  const std::uint32_t width = std::max(1u, texture.width >> mip);
  const std::uint32_t height = std::max(1u, texture.height >> mip);
  std::vector<std::uint8_t> texels(std::size_t{width} * height, kClearIndex);
  // One more at either end, for error that falls beside the texture.
  std::vector<float> carried(width + 2, 0.0f), carried_down(width + 2, 0.0f);
  for (std::uint32_t y = 0; y < height; ++y) {
    for (std::uint32_t x = 0; x < width; ++x) {
      const Block block = block_at(texture, x, y, mip, tables);
      const float wanted =
          static_cast<float>(block.opaque) / static_cast<float>(std::max(1, block.texels)) + carried[x + 1];
      const bool opaque = block.opaque > 0 && wanted >= 0.5f;
      if (opaque) texels[std::size_t{y} * width + x] = block.mean;
      const float error = wanted - (opaque ? 1.0f : 0.0f);
      carried[x + 2] += error * (7.0f / 16);
      carried_down[x] += error * (3.0f / 16);
      carried_down[x + 1] += error * (5.0f / 16);
      carried_down[x + 2] += error * (1.0f / 16);
    }
    carried.swap(carried_down);
    std::fill(carried_down.begin(), carried_down.end(), 0.0f);
  }
  return texels;
}

}  // namespace

CutoutTextures::CutoutTextures(const world::Level& level, const ColorTables& tables)
    : remade_index_(level.textures.size(), kAsItIs) {
  for (std::size_t i = 0; i < level.textures.size(); ++i) {
    if (level.textures[i].kind != world::TextureKind::kCutout || level.textures[i].colors) continue;
    remade_index_[i] = static_cast<std::uint32_t>(remade_.size());
    world::Texture& texture = remade_.emplace_back(level.textures[i]);
    for (unsigned mip = 1; mip < texture.mips.size(); ++mip)
      texture.mips[mip] = make_mip(texture, mip, tables);
  }
}

const world::Texture& CutoutTextures::drawn(const world::Level& level, world::TextureIndex texture) const {
  const std::uint32_t remade = remade_index_[base::to_size(texture)];
  return remade == kAsItIs ? level.texture(texture) : remade_[remade];
}

}  // namespace temblor::render
