#include "formats/images/colored_texture.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "formats/images/resample.h"

namespace temblor::formats {
namespace {

constexpr int kMips = 4;
constexpr std::uint32_t kOpaque = 0xff000000u;
constexpr std::int32_t kFullLight = 255 * 255;
// Limit of the diffused error. The palette lacks many saturated colors; their error would grow over a row and
// smear into the next colors.
constexpr std::int32_t kMaxDiffused = 48 * 48;
// Dimmer glow never makes a texel full-bright. In units of linear light.
constexpr std::int32_t kMinGlow = 40 * 40;

using Light = std::array<std::int32_t, 3>;

Light color_light(std::uint32_t color) {
  const auto squared = [&](unsigned shift) {
    const auto channel = static_cast<std::int32_t>(color >> shift & 0xff);
    return channel * channel;
  };
  return {squared(16), squared(8), squared(0)};
}

// The weights are those of human vision (ITU-R BT.709), in 256ths.
std::int32_t luminance(const Light& light) {
  return (54 * light[0] + 183 * light[1] + 19 * light[2]) / 256;
}

// The inverse of squaring, for all values from 0 to kFullLight.
class RootTable {
 public:
  RootTable() : roots_(kFullLight + 1) {
    for (std::size_t i = 0; i < roots_.size(); ++i)
      roots_[i] = static_cast<std::uint8_t>(std::lround(std::sqrt(static_cast<double>(i))));
  }
  std::uint8_t operator()(std::int32_t light) const {
    return roots_[static_cast<std::size_t>(std::clamp(light, 0, kFullLight))];
  }

 private:
  std::vector<std::uint8_t> roots_;
};

// The mean of four texels, weighted by their alpha. Alpha itself is the plain mean.
std::uint32_t average_four(const std::array<std::uint32_t, 4>& texels, const RootTable& root) {
  if ((texels[0] & texels[1] & texels[2] & texels[3]) >= kOpaque) {  // nearly always, and without divisions
    Light sum{2, 2, 2};
    for (const std::uint32_t texel : texels) {
      const Light light = color_light(texel);
      for (std::size_t c = 0; c < sum.size(); ++c) sum[c] += light[c];
    }
    return kOpaque | std::uint32_t{root(sum[0] / 4)} << 16 | std::uint32_t{root(sum[1] / 4)} << 8 |
           root(sum[2] / 4);
  }
  std::int32_t weight = 0;
  Light sum{};
  for (const std::uint32_t texel : texels) {
    const auto alpha = static_cast<std::int32_t>(texel >> 24);
    const Light light = color_light(texel);
    weight += alpha;
    for (std::size_t c = 0; c < sum.size(); ++c) sum[c] += alpha * light[c];
  }
  if (weight == 0) return 0;
  const auto channel = [&](std::size_t c) { return std::uint32_t{root((sum[c] + weight / 2) / weight)}; };
  const auto alpha = static_cast<std::uint32_t>((weight + 2) / 4);
  return alpha << 24 | channel(0) << 16 | channel(1) << 8 | channel(2);
}

Image halve_image(const Image& above, const RootTable& root) {
  Image half{std::max(1u, above.width / 2), std::max(1u, above.height / 2), {}};
  half.pixels.reserve(std::size_t{half.width} * half.height);
  for (std::uint32_t y = 0; y < half.height; ++y) {
    const std::uint32_t* upper = above.pixels.data() + std::size_t{2 * y} * above.width;
    const std::uint32_t* lower = above.height > 1 ? upper + above.width : upper;
    for (std::uint32_t x = 0; x < half.width; ++x) {
      const std::size_t left = std::size_t{2} * x, right = above.width > 1 ? left + 1 : left;
      half.pixels.push_back(average_four({upper[left], upper[right], lower[left], lower[right]}, root));
    }
  }
  return half;
}

// Makes each texel clear or opaque so that every part of the picture stays as opaque as its alpha says, by
// error diffusion. A texel without any opacity stays clear.
void dither_holes(Image& io_image) {
  const std::size_t width = io_image.width;
  // In 16ths of an alpha step. One more at either end, for error that leaves the row.
  std::vector<std::int32_t> row(width + 2, 0), below(width + 2, 0);
  for (std::uint32_t y = 0; y < io_image.height; ++y) {
    std::swap(row, below);
    std::ranges::fill(below, 0);
    for (std::size_t x = 0; x < width; ++x) {
      std::uint32_t& texel = io_image.pixels[y * width + x];
      const auto alpha = static_cast<std::int32_t>(texel >> 24);
      const std::int32_t wanted = alpha + row[x + 1] / 16;
      const bool opaque = alpha > 0 && wanted >= 128;
      texel = opaque ? texel | kOpaque : 0;
      const std::int32_t error = wanted - (opaque ? 255 : 0);
      row[x + 2] += 7 * error;
      below[x] += 3 * error;
      below[x + 1] += 5 * error;
      below[x + 2] += error;
    }
  }
}

// Maps one level to the palette, row by row.
class PaletteMatcher {
 public:
  PaletteMatcher(const MipColors& colors, const RootTable& root) : colors_(colors), root_(root) {
    for (std::size_t i = 0; i < palette_light_.size(); ++i) {
      const Rgb color = colors.palette[i];
      palette_light_[i] = {color.r * color.r, color.g * color.g, color.b * color.b};
    }
  }

  // `glow` has the size of `image`, or is empty. Texels of alpha 0 become transparent.
  std::vector<std::uint8_t> match(const Image& image, const Image& glow) {
    std::vector<std::uint8_t> indices(image.pixels.size());
    // One more at either end, for error that leaves the row.
    row_.assign(image.width + 2, Light{});
    below_.assign(image.width + 2, Light{});
    for (std::size_t first = 0; first < indices.size(); first += image.width) {
      std::swap(row_, below_);
      std::ranges::fill(below_, Light{});
      for (std::size_t x = 0; x < image.width; ++x) {
        const std::uint32_t texel = image.pixels[first + x];
        std::uint8_t& index = indices[first + x];
        if (texel >> 24 == 0)
          index = kTransparentIndex;
        else if (!glow.pixels.empty() && glows(texel, glow.pixels[first + x]))
          index = colors_.bright.find(add_colors(texel, glow.pixels[first + x]));
        else
          index = match_diffused(color_light(texel), x + 1);
      }
    }
    return indices;
  }

 private:
  static bool glows(std::uint32_t texel, std::uint32_t glow) {
    const std::int32_t light = luminance(color_light(glow));
    return light >= kMinGlow && light >= luminance(color_light(texel));
  }
  static Rgb add_colors(std::uint32_t texel, std::uint32_t glow) {
    const auto channel = [&](unsigned shift) {
      return static_cast<std::uint8_t>(std::min(255u, (texel >> shift & 0xff) + (glow >> shift & 0xff)));
    };
    return {channel(16), channel(8), channel(0)};
  }

  std::uint8_t match_diffused(const Light& light, std::size_t at) {
    Light wanted;
    for (std::size_t c = 0; c < wanted.size(); ++c) wanted[c] = light[c] + row_[at][c] / 16;
    const std::uint8_t index = colors_.dull.find({root_(wanted[0]), root_(wanted[1]), root_(wanted[2])});
    for (std::size_t c = 0; c < wanted.size(); ++c) {
      const std::int32_t error =
          std::clamp(wanted[c] - palette_light_[index][c], -kMaxDiffused, kMaxDiffused);
      row_[at + 1][c] += 7 * error;
      below_[at - 1][c] += 3 * error;
      below_[at][c] += 5 * error;
      below_[at + 1][c] += error;
    }
    return index;
  }

  const MipColors& colors_;
  const RootTable& root_;
  std::array<Light, 256> palette_light_;
  std::vector<Light> row_, below_;  // diffused errors, in 16ths
};

int choose_detail(const TextureFrame& frame, const Image& picture) {
  int detail = 0;
  while (detail < kMaxTextureDetail &&
         (frame.width << detail < picture.width || frame.height << detail < picture.height))
    ++detail;
  return detail;
}

// Alpha is 0 or 255 afterward.
void settle_alpha(bool has_holes, Image& io_image) {
  for (std::uint32_t& pixel : io_image.pixels) pixel = !has_holes || pixel >> 24 >= 128 ? pixel | kOpaque : 0;
}

}  // namespace

std::size_t count_bytes(const ColoredTexture& texture) {
  std::size_t bytes = 0;
  const auto add = [&](const auto& levels) {
    for (const auto& level : levels) bytes += level.size() * sizeof(level[0]);
  };
  add(texture.mips);
  add(texture.colors.fine_indices);
  add(texture.colors.colors);
  add(texture.colors.glow);
  return bytes;
}

ColoredTexture make_colored_texture(const TextureFrame& frame, Image picture, const Image& glow,
                                    const MipColors& colors) {
  CHECK(frame.width > 0 && frame.height > 0 && picture.width > 0 && picture.height > 0);
  ColoredTexture made;
  const int detail = made.colors.detail = choose_detail(frame, picture);
  const std::uint32_t width = frame.width << detail, height = frame.height << detail;
  // Before, so that the colors of transparent pixels count if the texture has no holes.
  if (!frame.has_holes) settle_alpha(false, picture);
  Image level = resample(std::move(picture), width, height);
  if (frame.has_holes) settle_alpha(true, level);
  Image glow_level = glow.pixels.empty() ? Image{} : resample(glow, width, height);
  static const RootTable root;  // takes a millisecond
  PaletteMatcher matcher(colors, root);
  for (int mip = -detail; mip < kMips; ++mip) {
    Image drawn = level;
    if (frame.has_holes && mip > -detail) dither_holes(drawn);
    std::vector<std::uint8_t> indices = matcher.match(drawn, glow_level);
    if (mip < 0)
      made.colors.fine_indices.insert(made.colors.fine_indices.begin(), std::move(indices));
    else
      made.mips[static_cast<std::size_t>(mip)] = std::move(indices);
    made.colors.colors.push_back(std::move(drawn.pixels));
    if (mip + 1 < kMips) level = halve_image(level, root);
    if (glow.pixels.empty()) continue;
    Image next_glow = mip + 1 < kMips ? halve_image(glow_level, root) : Image{};
    for (std::uint32_t& pixel : glow_level.pixels) pixel &= ~kOpaque;
    made.colors.glow.push_back(std::move(glow_level.pixels));
    glow_level = std::move(next_glow);
  }
  return made;
}

ColoredTexture make_colored_texture(const TextureFrame& frame, std::span<const std::uint8_t> indices,
                                    const Palette& own_palette, const MipColors& colors) {
  CHECK(indices.size() == std::size_t{frame.width} * frame.height, "{} texels for {} x {}", indices.size(),
        frame.width, frame.height);
  Image picture{frame.width, frame.height, {}};
  picture.pixels.reserve(indices.size());
  for (const std::uint8_t index : indices) {
    const Rgb color = own_palette[index];
    const bool clear = frame.has_holes && index == kTransparentIndex;
    picture.pixels.push_back(clear ? 0
                                   : kOpaque | std::uint32_t{color.r} << 16 | std::uint32_t{color.g} << 8 |
                                         std::uint32_t{color.b});
  }
  return make_colored_texture(frame, std::move(picture), {}, colors);
}

}  // namespace temblor::formats
