// Writes PNG files with libspng, for `render -o`, screenshots, and golden pictures. image.h has the reader.
#pragma once

#include <cstdint>
#include <span>

#include "base/bytes.h"
#include "base/result.h"
#include "formats/images/image.h"
#include "formats/images/palette.h"

namespace temblor::formats {

// Writes palette indices (row by row, no padding) as color type 3 with all 256 palette entries. CHECKs that
// the sides are positive and that there are width * height pixels. Returns kIo if the library fails.
base::Result<base::ByteVector> write_png(std::span<const std::uint8_t> indices, int width, int height,
                                         const Palette& palette);

// The same for pixels 0xffRRGGBB: color type 2 with 8 bits per channel; ignores the top byte.
base::Result<base::ByteVector> write_png(std::span<const std::uint32_t> rgb, int width, int height);

// With transparency: color type 6.
base::Result<base::ByteVector> write_png(const Image& image);

}  // namespace temblor::formats
