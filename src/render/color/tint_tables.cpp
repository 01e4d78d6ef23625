#include "render/color/tint_tables.h"

#include <algorithm>
#include <cmath>

namespace temblor::render {

TintTables::TintTables(const formats::Palette& palette, const PaletteMatch& match)
    : tables_(std::make_unique<Tables>(palette, match)) {}

TintTables::Rows TintTables::Tables::make_rows(const Color& color) const {
  Rows rows;
  for (int row = 0; row < kTintRows; ++row)
    for (std::size_t index = 0; index < 256; ++index) {
      // The share of white light, and the colored light's share of each channel, in parts of kSteps.
      const auto tint = [&](std::uint8_t value, int channel) {
        const int last = kTintRows - 1;
        const int factor = (last - row) * kSteps + row * channel;
        return static_cast<std::uint8_t>((value * factor + last * kSteps / 2) / (last * kSteps));
      };
      const formats::Rgb& entry = palette[index];
      const bool stays = row == 0 || index == formats::kTransparentIndex || match.is_fullbright(index);
      rows[static_cast<std::size_t>(row) * 256 + index] =
          stays ? static_cast<std::uint8_t>(index)
                : match({tint(entry.r, color[0]), tint(entry.g, color[1]), tint(entry.b, color[2])}, false);
    }
  return rows;
}

const std::uint8_t* TintTables::rows_for(const std::array<float, 3>& color) const {
  const float largest = std::max({color[0], color[1], color[2]});
  Color steps;
  std::size_t place = 0;
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const float ratio = largest > 0 ? std::clamp(color[channel] / largest, 0.0f, 1.0f) : 1.0f;
    steps[channel] = static_cast<int>(std::lround(ratio * kSteps));
    place = place * (kSteps + 1) + static_cast<std::size_t>(steps[channel]);
  }
  const std::lock_guard lock(tables_->mutex);
  std::unique_ptr<const Rows>& rows = tables_->made[place];
  if (!rows) rows = std::make_unique<const Rows>(tables_->make_rows(steps));
  return rows->data();
}

}  // namespace temblor::render
