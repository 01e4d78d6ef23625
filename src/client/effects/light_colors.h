// The colors of dynamic lights. The original's lights are white, and no message carries a color, so the cause
// of a light decides: explosions are orange, lightning is blue.
#pragma once

#include <cstdint>
#include <optional>

#include "client/effects/trails.h"
#include "math/vec.h"

namespace temblor::client {

// Red, green, and blue. The largest is 1, so that a colored light is never brighter than a white one.
constexpr math::Vec3 kWhiteLight{1.0f}, kBlastLight{1.0f, 0.68f, 0.36f}, kShotLight{1.0f, 0.84f, 0.58f},
    kLightningLight{0.5f, 0.72f, 1.0f};

// The color of an entity's glow, by its `effects` (EntityEffects), or else by its trail.
math::Vec3 choose_glow_color(std::uint8_t effects, std::optional<TrailKind> trail);

}  // namespace temblor::client
