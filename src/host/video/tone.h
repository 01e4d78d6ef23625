// Brightness of the finished picture, without the display's help.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "base/parallel_for.h"
#include "formats/images/palette.h"

namespace temblor::host {

struct Tone {
  float gamma = 1;       // below 1: brighter, dark most of all
  float contrast = 1;    // factor
  float brightness = 0;  // added: 1 would be white
  bool operator==(const Tone&) const = default;
  bool is_neutral() const { return *this == Tone{}; }
};

using ToneTable = std::array<std::uint8_t, 256>;
ToneTable tone_table(const Tone& tone);

void apply_tone(const ToneTable& table, base::Jobs& io_jobs, std::span<std::uint32_t> io_pixels);
formats::Palette toned(const formats::Palette& palette, const ToneTable& table);

}  // namespace temblor::host
