// Light in texels of TexelFormat::kLight: 10 bits for each channel.
#pragma once

#include <cstdint>

#include "render/surfaces/light/light_samples.h"

namespace temblor::render_gl {

// Samples of make_rgb_samples(): blue, green, red.
inline std::uint32_t pack_light(const std::int16_t* sample) {
  constexpr std::uint32_t kMaxSample = render::kFullLight / 2;
  const auto pack = [&](int channel) {
    return (static_cast<std::uint32_t>(sample[channel]) * 1023 + kMaxSample / 2) / kMaxSample;
  };
  return pack(0) | pack(1) << 10 | pack(2) << 20;
}

// The light of a texel that holds 1, as a factor of a texture's color.
inline constexpr const char* kLightScalePart = R"(
const float kLightScale = 32640.0 / 16384.0;
)";

}  // namespace temblor::render_gl
