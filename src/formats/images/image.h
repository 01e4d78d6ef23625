// True-color images from files: TGA, the format of most mods, PNG, and JPEG.
#pragma once

#include <cstdint>
#include <vector>

#include "base/bytes.h"
#include "base/result.h"

namespace temblor::formats {

constexpr std::uint32_t kMaxImageSide = 1 << 13;  // pixels

struct Image {
  std::uint32_t width = 0, height = 0;  // 1 to kMaxImageSide
  std::vector<std::uint32_t> pixels;    // 0xAARRGGBB, row by row from the top
  bool operator==(const Image&) const = default;
};

// Reads color-mapped, true-color, and gray TGA files of 8 to 32 bits, with or without run-length encoding.
// image_tga.cpp shows the layout, and which faults are passed over.
base::Result<Image> read_tga(base::Bytes bytes);
// Writes 32 bits per pixel, without compression.
base::ByteVector write_tga(const Image& image);
// Reads any PNG.
base::Result<Image> read_png(base::Bytes bytes);
// Reads gray and color JPEG files of at most 2^24 pixels, also progressive ones of at most 64 scans and 2^28
// pixels in all scans. All readers return kMalformed, kUnsupported, or kTooLarge with the reason.
base::Result<Image> read_jpeg(base::Bytes bytes);

}  // namespace temblor::formats
