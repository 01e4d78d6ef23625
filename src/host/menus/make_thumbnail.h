// Small pictures for the menus, in the palette's colors.
#pragma once

#include <cstdint>
#include <span>

#include "formats/images/nearest_color.h"
#include "formats/images/picture.h"

namespace temblor::host {

constexpr int kThumbnailWidth = 160, kThumbnailHeight = 100;

// Scales a picture to the thumbnail size, times `factor`, with a box filter: each pixel is the mean of the
// pixels that it covers. `rgb` holds rows of `width` pixels 0xffRRGGBB, from top to bottom; the picture must
// not be empty.
formats::Picture make_thumbnail(std::span<const std::uint32_t> rgb, int width, int height,
                                const formats::NearestColor& colors, int factor = 1);

}  // namespace temblor::host
