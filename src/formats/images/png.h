// PNG writing: what `render -o` and `screenshot` give.
#pragma once

#include <cstdint>
#include <span>

#include "base/bytes.h"
#include "base/result.h"
#include "formats/images/image.h"
#include "formats/images/palette.h"

namespace temblor::formats {

// width x height palette indices, row by row (no padding), as a PNG of color type 3 that keeps all 256
// palette entries. CHECKs that the sides are positive and that there are width * height pixels.
base::Result<base::ByteVector> write_png(std::span<const std::uint8_t> indices, int width, int height,
                                         const Palette& palette);

// The same for pixels 0xffRRGGBB: color type 2, 8 bits each; the top byte is ignored.
base::Result<base::ByteVector> write_png(std::span<const std::uint32_t> rgb, int width, int height);

// With transparency: color type 6.
base::Result<base::ByteVector> write_png(const Image& image);

}  // namespace temblor::formats
