// When a color with an opacity becomes a palette entry that can be seen.
#pragma once

#include <cstdint>

namespace temblor::formats {

// Palette indices are blended in sixteenths of opacity. Less than half a sixteenth, of 255, is clear.
constexpr std::uint32_t kMinVisibleAlpha = 8;

}  // namespace temblor::formats
