#include "host/video/tone.h"

#include <algorithm>
#include <cmath>

namespace temblor::host {

ToneTable make_tone_table(const Tone& tone) {
  ToneTable table{};
  // Rounding in the formula must not change a neutral picture.
  if (tone.is_neutral()) {
    for (std::size_t i = 0; i < table.size(); ++i) table[i] = static_cast<std::uint8_t>(i);
    return table;
  }
  for (std::size_t i = 0; i < table.size(); ++i) {
    const float curved = 255 * std::pow((static_cast<float>(i) + 0.5f) / 255.5f, tone.gamma) + 0.5f;
    const float shown = curved * tone.contrast + 255 * tone.brightness;
    table[i] = static_cast<std::uint8_t>(std::clamp(shown, 0.0f, 255.0f));
  }
  return table;
}

void apply_tone(const ToneTable& table, base::Jobs& io_jobs, std::span<std::uint32_t> io_pixels) {
  const auto slices = static_cast<std::size_t>(io_jobs.threads()) * 4;
  io_jobs.parallel_for(slices, [&](std::size_t slice) {
    const std::size_t first = io_pixels.size() * slice / slices;
    for (std::uint32_t& pixel : io_pixels.subspan(first, io_pixels.size() * (slice + 1) / slices - first))
      pixel = 0xff000000u | std::uint32_t{table[pixel >> 16 & 255]} << 16 |
              std::uint32_t{table[pixel >> 8 & 255]} << 8 | table[pixel & 255];
  });
}

formats::Palette apply_tone(const ToneTable& table, const formats::Palette& palette) {
  formats::Palette result = palette;
  for (std::size_t i = 0; i < 256; ++i)
    result[i] = {table[palette[i].r], table[palette[i].g], table[palette[i].b]};
  return result;
}

}  // namespace temblor::host
