#include "render/color/blend_tables.h"

#include <algorithm>
#include <cmath>

namespace temblor::render {

namespace {

constexpr std::size_t kTableSize = 256 * 256;
constexpr std::size_t kClear = 255;

}  // namespace

BlendTables::Tables::Tables(const formats::Palette& source_palette, const PaletteMatch& source_match)
    : palette(source_palette),
      match(source_match),
      bytes(std::make_unique_for_overwrite<std::uint8_t[]>(kSteps * kTableSize)) {}

// a over b at n sixteenths is the same as b over a at 16 - n sixteenths: one table is the transpose of the
// other.
void BlendTables::Tables::make_pair(int step) {
  std::uint8_t* const table = bytes.get() + static_cast<std::size_t>(step - 1) * kTableSize;
  std::uint8_t* const mirror = bytes.get() + static_cast<std::size_t>(kSteps - step - 1) * kTableSize;
  for (std::size_t over = 0; over < 256; ++over)
    for (std::size_t under = 0; under < 256; ++under) {
      const bool fullbright = match.is_fullbright(over) || match.is_fullbright(under);
      const formats::Rgb mean = blend_colors(palette[over], palette[under], step * (kOpaque256 / kSteps));
      table[over * 256 + under] = mirror[under * 256 + over] = match(mean, fullbright);
    }
}

void BlendTables::Tables::make_sums() {
  std::uint8_t* const table = bytes.get() + (kSteps - 1) * kTableSize;
  const auto add = [](std::uint8_t a, std::uint8_t b) {
    return static_cast<std::uint8_t>(std::min(int{a} + int{b}, 255));
  };
  for (std::size_t a = 0; a < 256; ++a)
    for (std::size_t b = 0; b <= a; ++b) {
      const formats::Rgb &one = palette[a], &other = palette[b];
      table[a * 256 + b] = table[b * 256 + a] =
          match({add(one.r, other.r), add(one.g, other.g), add(one.b, other.b)}, true);
    }
}

BlendTables::BlendTables(const formats::Palette& palette, const PaletteMatch& match)
    : tables_(std::make_unique<Tables>(palette, match)) {}

const std::uint8_t* BlendTables::table_for(float opacity) const {
  const int nearest = (opacity_256(opacity) + kOpaque256 / kSteps / 2) / (kOpaque256 / kSteps);
  const int step = std::clamp(nearest, 1, kSteps - 1);
  const int pair = std::min(step, kSteps - step);
  std::call_once(tables_->pair_is_made[static_cast<std::size_t>(pair - 1)],
                 [&] { tables_->make_pair(pair); });
  return tables_->bytes.get() + static_cast<std::size_t>(step - 1) * kTableSize;
}

const std::uint8_t* BlendTables::sums() const {
  std::call_once(tables_->sums_are_made, [&] { tables_->make_sums(); });
  return tables_->bytes.get() + (kSteps - 1) * kTableSize;
}

void BlendTables::make_all() const {
  for (int pair = 1; pair <= kSteps / 2; ++pair)
    table_for(static_cast<float>(pair) / static_cast<float>(kSteps));
  sums();
}

const std::uint8_t* FogTables::rows_for(const math::Vec3& color, const formats::Palette& palette,
                                        const PaletteMatch& match) {
  const formats::Rgb fog = to_bytes(color);
  if (color_ == fog) return rows_.data();
  color_ = fog;
  for (int row = 0; row < kRows; ++row)
    for (std::size_t index = 0; index < 256; ++index)
      rows_[static_cast<std::size_t>(row) * 256 + index] =
          row == 0 || index == kClear
              ? static_cast<std::uint8_t>(index)
              : match(blend_colors(fog, palette[index], row * kOpaque256 / (kRows - 1)),
                      match.is_fullbright(index));
  return rows_.data();
}

formats::Rgb to_bytes(const math::Vec3& color) {
  const auto channel = [](float value) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0f, 1.0f) * 255.0f));
  };
  return {channel(color.r), channel(color.g), channel(color.b)};
}

}  // namespace temblor::render
