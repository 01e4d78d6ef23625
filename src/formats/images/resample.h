// Changes the size of an image.
#pragma once

#include <cstdint>

#include "formats/images/image.h"

namespace temblor::formats {

// Each pixel of the result is the mean of the part of `image` that it covers, weighted by alpha. So enlarged
// pixels stay squares, and reduced ones do not flicker. Means are taken in linear light (the square of a
// channel). `image` is not empty; sizes are at least 1.
Image resample(Image image, std::uint32_t width, std::uint32_t height);

}  // namespace temblor::formats
