// True-color pictures from files: skyboxes.
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

// Color-mapped, true-color and gray, 8 to 32 bits, run-length coded or not, from either corner.
base::Result<Image> read_tga(base::Bytes bytes);
// 32 bits, uncoded.
base::ByteVector write_tga(const Image& image);
// Any PNG.
base::Result<Image> read_png(base::Bytes bytes);

}  // namespace temblor::formats
