// Gamma, contrast and brightness of the finished picture. They are applied to its pixels instead of the
// display's gamma ramp, so that they work the same on every display and in screenshots:
//
//   shown = (255 * ((value + 0.5) / 255.5) ^ gamma + 0.5) * contrast + 255 * brightness, clamped to 0 .. 255
//
// The inner term is the gamma table of the stock game.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "base/parallel_for.h"
#include "formats/images/palette.h"

namespace temblor::host {

struct Tone {
  float gamma = 1;       // an exponent; below 1 brightens, most of all dark areas
  float contrast = 1;    // a factor
  float brightness = 0;  // an offset; 1 turns black into white
  bool operator==(const Tone&) const = default;
  bool is_neutral() const { return *this == Tone{}; }
};

// Maps the old value of a channel to the new one. The same table applies to red, green and blue.
using ToneTable = std::array<std::uint8_t, 256>;
ToneTable make_tone_table(const Tone& tone);

// Applies the table to pixels 0xffRRGGBB, on all threads of `io_jobs`.
void apply_tone(const ToneTable& table, base::Jobs& io_jobs, std::span<std::uint32_t> io_pixels);
formats::Palette apply_tone(const ToneTable& table, const formats::Palette& palette);

}  // namespace temblor::host
