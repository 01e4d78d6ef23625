#include "formats/images/build_mips.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"

namespace temblor::formats {
namespace {

constexpr std::int32_t kMaxLight = 255 * 255;
// Limit of the diffused error. Dull colors cannot represent every mean with fullbright texels; the error
// would accumulate into a smear.
constexpr std::int32_t kMaxError = kMaxLight;

// Linear light: red, green, and blue, squared.
using Light = std::array<std::int32_t, 3>;

Light to_light(Rgb color) {
  return {color.r * color.r, color.g * color.g, color.b * color.b};
}

// The inverse of to_light(), clamped to the displayable range.
Rgb to_color(const Light& light) {
  const auto channel = [](std::int32_t squared) {
    const auto shown = static_cast<double>(std::clamp(squared, 0, kMaxLight));
    return static_cast<std::uint8_t>(std::lround(std::sqrt(shown)));
  };
  return {channel(light[0]), channel(light[1]), channel(light[2])};
}

// A mip level before and after mapping to the palette. The next level averages the exact colors, so that it
// does not average dithering, and takes holes and fullbright texels from the mapped indices.
struct Level {
  std::uint32_t width, height;
  std::vector<Light> lights;
  std::vector<std::uint8_t> indices;
};

enum class TexelKind : std::uint8_t { kDull, kPartlyBright, kBright, kHole };

struct Texel {
  Light light{};
  TexelKind kind = TexelKind::kHole;
};

// Averages the texels of the level above that are not transparent, and votes on the kind of the result.
Texel average_four(const Level& above, std::uint32_t x, std::uint32_t y, bool has_holes) {
  Light sum{};
  std::int32_t seen = 0, bright = 0;
  for (const std::uint32_t row : {2 * y, 2 * y + 1})
    for (const std::uint32_t column : {2 * x, 2 * x + 1}) {
      const std::size_t at = std::size_t{row} * above.width + column;
      if (has_holes && above.indices[at] == kTransparentIndex) continue;
      ++seen;
      bright += above.indices[at] >= kFirstFullbright;
      for (std::size_t c = 0; c < sum.size(); ++c) sum[c] += above.lights[at][c];
    }
  Texel texel;
  if (seen == 0) return texel;
  for (std::size_t c = 0; c < sum.size(); ++c) texel.light[c] = (sum[c] + seen / 2) / seen;
  if (seen > 1)
    texel.kind = bright == seen       ? TexelKind::kBright
                 : 2 * bright >= seen ? TexelKind::kPartlyBright
                                      : TexelKind::kDull;
  return texel;
}

std::uint8_t find_mip_index(const MipColors& colors, TexelKind kind, const Light& light) {
  const Rgb color = to_color(light);
  switch (kind) {
    case TexelKind::kDull:
      return colors.dull.find(color);
    case TexelKind::kPartlyBright:
      return colors.any.find(color);
    case TexelKind::kBright:
      return colors.bright.find(color);
    case TexelKind::kHole:
      break;
  }
  return kTransparentIndex;
}

// Diffused errors of a row of texels, in 16ths.
using ErrorRow = std::vector<Light>;

// Adds the error of a texel to its neighbors that are not mapped yet, with the weights of Floyd and
// Steinberg:
//
//         *   7/16
//   3/16 5/16 1/16
//
// Textures repeat, so errors that leave a row on one side enter on the other side; small levels would lose a
// large part of the error otherwise.
void diffuse_error(const Light& error, std::size_t x, ErrorRow& io_row, ErrorRow& io_below) {
  const std::size_t width = io_row.size();
  const std::size_t left = x == 0 ? width - 1 : x - 1;
  const bool is_last = x + 1 == width;
  const std::size_t right = is_last ? 0 : x + 1;
  ErrorRow& io_ahead = is_last ? io_below : io_row;
  for (std::size_t c = 0; c < error.size(); ++c) {
    const std::int32_t bounded = std::clamp(error[c], -kMaxError, kMaxError);
    io_ahead[right][c] += 7 * bounded;
    io_below[left][c] += 3 * bounded;
    io_below[x][c] += 5 * bounded;
    io_below[right][c] += bounded;
  }
}

// Computes the next smaller mip level.
Level halve(const Level& above, bool has_holes, const MipColors& colors) {
  Level level{above.width / 2, above.height / 2, {}, {}};
  level.lights.reserve(std::size_t{level.width} * level.height);
  level.indices.reserve(level.lights.capacity());
  ErrorRow row(level.width), below(level.width);
  for (std::uint32_t y = 0; y < level.height; ++y) {
    std::swap(row, below);
    std::ranges::fill(below, Light{});
    for (std::uint32_t x = 0; x < level.width; ++x) {
      const Texel texel = average_four(above, x, y, has_holes);
      level.lights.push_back(texel.light);
      Light wanted = texel.light;
      for (std::size_t c = 0; c < wanted.size(); ++c) wanted[c] += row[x][c] / 16;
      const std::uint8_t index = find_mip_index(colors, texel.kind, wanted);
      level.indices.push_back(index);
      if (texel.kind == TexelKind::kHole) continue;
      const Light got = to_light(colors.palette[index]);
      diffuse_error({wanted[0] - got[0], wanted[1] - got[1], wanted[2] - got[2]}, x, row, below);
    }
  }
  return level;
}

}  // namespace

std::array<std::vector<std::uint8_t>, 4> build_mips(std::vector<std::uint8_t> mip0, std::uint32_t width,
                                                    std::uint32_t height, bool has_holes,
                                                    const MipColors& colors) {
  CHECK(mip0.size() == std::size_t{width} * height, "{} texels for {} x {}", mip0.size(), width, height);
  Level level{width, height, {}, std::move(mip0)};
  level.lights.reserve(level.indices.size());
  for (const std::uint8_t index : level.indices) level.lights.push_back(to_light(colors.palette[index]));
  std::array<std::vector<std::uint8_t>, 4> mips;
  for (std::size_t k = 0; k + 1 < mips.size(); ++k) {
    Level next = halve(level, has_holes, colors);
    mips[k] = std::move(level.indices);
    level = std::move(next);
  }
  mips.back() = std::move(level.indices);
  return mips;
}

}  // namespace temblor::formats
