// Each material is a function from a texel to a palette index. It is written for the full size; small
// textures sample it at every fourth texel.
#include "artgen/level/materials.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <unordered_map>

#include "artgen/palette.h"
#include "artgen/scripts/noise.h"
#include "base/text.h"

namespace temblor::artgen {
namespace {

// Texels of a full-size texture. A sky consists of two squares that are twice as wide.
constexpr std::int32_t kSide = 64;
constexpr std::int32_t kSkySide = 2 * kSide;
constexpr std::int32_t kTinyShrink = 4;

using Painter = std::uint8_t (*)(std::int32_t x, std::int32_t y, std::uint64_t seed);

// The distance in texels to the nearest line of a grid with this spacing.
std::int32_t distance_to_joint(std::int32_t position, std::int32_t spacing) {
  const std::int32_t within = position % spacing;
  return std::min(within, spacing - 1 - within);
}

// The tone that a block's beveled edge adds: lighter above and left, darker below and right, as if lit from
// the upper left.
double shade_bevel(std::int32_t x, std::int32_t y, std::int32_t width, std::int32_t height) {
  if (x % width == 1 || y % height == 1) return 0.12;
  if (x % width == width - 1 || y % height == height - 1) return -0.12;
  return 0;
}

std::uint8_t paint_brick(std::int32_t x, std::int32_t y, std::uint64_t seed) {
  constexpr std::int32_t kWidth = 32;
  constexpr std::int32_t kHeight = 16;
  const std::int32_t row = y / kHeight;
  const std::int32_t shifted = (x + row % 2 * kWidth / 2) % kSide;
  const double noise = tiling_noise(x, y, kSide, 8, seed);
  if (shifted % kWidth == 0 || y % kHeight == 0) return ramp_color(Ramp::kGray, 0.12 + 0.16 * noise);
  const double tone = hash_noise(shifted / kWidth, row, seed) * 0.18;
  return ramp_color(Ramp::kBrick, 0.24 + tone + 0.34 * noise + shade_bevel(shifted, y, kWidth, kHeight));
}

std::uint8_t paint_slabs(std::int32_t x, std::int32_t y, std::uint64_t seed) {
  constexpr std::int32_t kSlab = 32;
  const double noise = tiling_noise(x, y, kSide, 16, seed);
  if (x % kSlab == 0 || y % kSlab == 0) return ramp_color(Ramp::kBrown, 0.14 + 0.1 * noise);
  const double tone = hash_noise(x / kSlab, y / kSlab, seed) * 0.12;
  return ramp_color(Ramp::kSand, 0.2 + tone + 0.36 * noise + shade_bevel(x, y, kSlab, kSlab));
}

std::uint8_t paint_concrete(std::int32_t x, std::int32_t y, std::uint64_t seed) {
  const double seam = distance_to_joint(x, kSide) == 0 || distance_to_joint(y, kSide) == 0 ? -0.1 : 0;
  return ramp_color(Ramp::kSlate, 0.28 + seam + 0.34 * tiling_noise(x, y, kSide, 8, seed));
}

std::uint8_t paint_trim(std::int32_t x, std::int32_t y, std::uint64_t seed) {
  constexpr std::int32_t kBand = 16;
  const std::int32_t edge = std::min(distance_to_joint(x, kBand), distance_to_joint(y, kSide));
  const double groove = edge == 0 ? -0.18 : edge == 1 ? 0.1 : 0;
  return ramp_color(Ramp::kRust, 0.3 + groove + 0.3 * tiling_noise(x, y, kSide, 16, seed));
}

std::uint8_t paint_stone(std::int32_t x, std::int32_t y, std::uint64_t seed) {
  constexpr std::int32_t kHeight = 32;
  const std::int32_t shifted = (x + y / kHeight * 24) % kSide;
  const double noise = tiling_noise(x, y, kSide, 16, seed);
  if (shifted == 0 || y % kHeight == 0) return ramp_color(Ramp::kGray, 0.16 + 0.12 * noise);
  return ramp_color(Ramp::kGray, 0.3 + 0.36 * noise + shade_bevel(shifted, y, kSide, kHeight));
}

std::uint8_t paint_earth(std::int32_t x, std::int32_t y, std::uint64_t seed) {
  const double grass = tiling_noise(x, y, kSide, 32, seed + 100);
  const double noise = tiling_noise(x, y, kSide, 4, seed);
  return ramp_color(grass > 0.52 ? Ramp::kOlive : Ramp::kBrown, 0.22 + 0.44 * noise);
}

// A lamp: light tubes in a frame. The frames of the animation brighten different tubes.
std::uint8_t paint_panel(std::int32_t x, std::int32_t y, Ramp ramp, std::int32_t bright_tube) {
  constexpr std::int32_t kTubes = 4;
  constexpr std::int32_t kTubeWidth = kSide / kTubes;
  if (std::min(distance_to_joint(x, kSide), distance_to_joint(y, kSide)) < 4)
    return ramp_color(Ramp::kSlate, 0.35);
  const std::int32_t tube = x / kTubeWidth;
  const double across = std::abs(x % kTubeWidth - kTubeWidth / 2 + 0.5) / (kTubeWidth / 2.0);
  if (across > 0.7) return ramp_color(Ramp::kSlate, 0.2);
  return ramp_color(ramp, (tube == bright_tube ? 1.0 : 0.72) - 0.5 * across);
}
std::uint8_t paint_panel_0(std::int32_t x, std::int32_t y, std::uint64_t) {
  return paint_panel(x, y, Ramp::kFire, 0);
}
std::uint8_t paint_panel_1(std::int32_t x, std::int32_t y, std::uint64_t) {
  return paint_panel(x, y, Ramp::kFire, 2);
}
std::uint8_t paint_panel_alternate(std::int32_t x, std::int32_t y, std::uint64_t) {
  return paint_panel(x, y, Ramp::kElectric, 1);
}

std::uint8_t paint_door(std::int32_t x, std::int32_t y, std::uint64_t seed) {
  constexpr std::int32_t kPlate = 32;
  const double noise = tiling_noise(x, y, kSide, 8, seed);
  const std::int32_t dx = x % kPlate - kPlate / 2;
  const std::int32_t dy = y % kPlate - kPlate / 2;
  if (std::abs(dx) + std::abs(dy) < 5)
    return ramp_color(Ramp::kElectric, 0.9 - 0.1 * (dx * dx + dy * dy) / 4.0);
  return ramp_color(Ramp::kTeal, 0.26 + 0.24 * noise + shade_bevel(x, y, kPlate, kPlate) * 1.5);
}

std::uint8_t paint_water(std::int32_t x, std::int32_t y, std::uint64_t seed) {
  const double turn = 2 * std::numbers::pi / kSide;
  const double waves =
      std::sin(turn * (2 * x + y)) + std::sin(turn * (3 * y - x)) + std::sin(turn * (x - 4 * y));
  return ramp_color(Ramp::kBlue, 0.36 + 0.06 * waves + 0.3 * tiling_noise(x, y, kSide, 16, seed));
}

// The left half has clouds, with index 0 where the background shows through. The right half is the
// background. The engine scrolls them at different speeds.
std::uint8_t paint_sky(std::int32_t x, std::int32_t y, std::uint64_t seed) {
  if (x < kSkySide) {
    const double cloud = tiling_noise(x, y, kSkySide, 32, seed);
    return cloud < 0.5 ? std::uint8_t{0} : ramp_color(Ramp::kSlate, 0.4 + 1.4 * (cloud - 0.5));
  }
  const double haze = tiling_noise(x - kSkySide, y, kSkySide, 64, seed + 7);
  return ramp_color(Ramp::kBlue, 0.34 + 0.5 * haze);
}

struct MaterialPainter {
  const char* name;
  Painter painter;
};
// In the order of Material. The names follow Quake's rules: "+0" and "+1" are the frames of an animation,
// "+a" its alternate frame, "*" marks a liquid.
constexpr MaterialPainter kPainters[] = {
    {"brick", paint_brick},     {"slabs", paint_slabs},     {"concrete", paint_concrete},
    {"trim", paint_trim},       {"stone", paint_stone},     {"earth", paint_earth},
    {"+0panel", paint_panel_0}, {"door", paint_door},       {"*water", paint_water},
    {"sky_dusk", paint_sky},    {"+1panel", paint_panel_1}, {"+apanel", paint_panel_alternate},
};

// Finds palette colors for averages of texels. Remembers them, because a texture has few different averages.
class AverageColors {
 public:
  // Returns the color nearest to the average of a square of texels. It is full-bright if more than half of
  // the texels are.
  std::uint8_t find(const formats::BspMiptex& miptex, std::uint32_t x0, std::uint32_t y0, std::uint32_t side);

 private:
  std::uint8_t find_nearest(const formats::Rgb& average, bool bright) const;

  formats::Palette palette_ = make_palette();
  // By average color in the lower 24 bits, and full-bright or not in the next one.
  std::unordered_map<std::uint32_t, std::uint8_t> found_;
};

std::uint8_t AverageColors::find(const formats::BspMiptex& miptex, std::uint32_t x0, std::uint32_t y0,
                                 std::uint32_t side) {
  std::uint32_t red = 0, green = 0, blue = 0, fullbright = 0;
  for (std::uint32_t y = y0; y < y0 + side; ++y) {
    for (std::uint32_t x = x0; x < x0 + side; ++x) {
      const std::uint8_t texel = miptex.mips[0][y * miptex.width + x];
      red += palette_[texel].r;
      green += palette_[texel].g;
      blue += palette_[texel].b;
      fullbright += texel >= kFirstFullbright ? 1 : 0;
    }
  }
  const std::uint32_t count = side * side;
  const bool bright = fullbright * 2 > count;
  const auto average = [count](std::uint32_t sum) { return static_cast<std::uint8_t>(sum / count); };
  const formats::Rgb color{average(red), average(green), average(blue)};
  const std::uint32_t key =
      (bright ? 1u << 24 : 0u) | std::uint32_t{color.r} << 16 | std::uint32_t{color.g} << 8 | color.b;
  const auto [place, is_new] = found_.try_emplace(key);
  if (is_new) place->second = find_nearest(color, bright);
  return place->second;
}

std::uint8_t AverageColors::find_nearest(const formats::Rgb& average, bool bright) const {
  const int first = bright ? kFirstFullbright : 0;
  const int last = bright ? kTransparent : kFirstFullbright;
  int best = first;
  int best_distance = std::numeric_limits<int>::max();
  for (int i = first; i < last; ++i) {
    const formats::Rgb& color = palette_[static_cast<std::size_t>(i)];
    const int dr = color.r - average.r, dg = color.g - average.g, db = color.b - average.b;
    const int distance = dr * dr + dg * dg + db * db;
    if (distance < best_distance) {
      best = i;
      best_distance = distance;
    }
  }
  return static_cast<std::uint8_t>(best);
}

// Each mip level averages squares of the full-size texture.
void add_mips(AverageColors& io_colors, formats::BspMiptex& io_miptex) {
  for (std::uint32_t mip = 1; mip < io_miptex.mips.size(); ++mip) {
    const std::uint32_t side = 1u << mip;
    for (std::uint32_t y = 0; y < io_miptex.height; y += side)
      for (std::uint32_t x = 0; x < io_miptex.width; x += side)
        io_miptex.mips[mip].push_back(io_colors.find(io_miptex, x, y, side));
  }
}

formats::BspMiptex paint(const MaterialPainter& material, std::int32_t shrink, std::uint64_t seed) {
  const bool is_sky = material.painter == paint_sky;
  const std::int32_t width = is_sky ? 2 * kSkySide : kSide;
  const std::int32_t height = is_sky ? kSkySide : kSide;
  formats::BspMiptex miptex;
  miptex.present = true;
  miptex.name = material.name;
  miptex.width = static_cast<std::uint32_t>(width / shrink);
  miptex.height = static_cast<std::uint32_t>(height / shrink);
  for (std::int32_t y = 0; y < height; y += shrink)
    for (std::int32_t x = 0; x < width; x += shrink) miptex.mips[0].push_back(material.painter(x, y, seed));
  return miptex;
}

// Whether a texture is the wanted one or another frame of its animation: "+0panel" and "+apanel".
bool is_same_texture(std::string_view name, std::string_view wanted) {
  constexpr std::size_t kFrameMark = 2;
  const bool are_frames = name.starts_with('+') && wanted.starts_with('+') && wanted.size() >= kFrameMark;
  return are_frames ? base::equal_ignoring_case(name.substr(kFrameMark), wanted.substr(kFrameMark))
                    : base::equal_ignoring_case(name, wanted);
}

}  // namespace

std::vector<formats::BspMiptex> make_materials(const SmallLevelOptions& options) {
  AverageColors colors;
  std::vector<formats::BspMiptex> miptexes;
  for (const MaterialPainter& material : kPainters) {
    miptexes.push_back(paint(material, options.tiny ? kTinyShrink : 1, options.seed));
    add_mips(colors, miptexes.back());
  }
  if (options.missing_texture) {
    formats::BspMiptex& brick = miptexes[static_cast<std::size_t>(Material::kBrick)];
    for (std::vector<std::uint8_t>& mip : brick.mips) mip.clear();
  }
  return miptexes;
}

std::vector<formats::BspMiptex> make_small_level_textures(std::span<const std::string_view> names) {
  AverageColors colors;
  std::vector<formats::BspMiptex> miptexes;
  for (const MaterialPainter& material : kPainters) {
    const auto is_this = [&](std::string_view name) { return is_same_texture(material.name, name); };
    if (std::ranges::none_of(names, is_this)) continue;
    miptexes.push_back(paint(material, 1, SmallLevelOptions{}.seed));
    add_mips(colors, miptexes.back());
  }
  return miptexes;
}

}  // namespace temblor::artgen
