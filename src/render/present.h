// Converts a frame to the 32-bit pixels that a window or a video file shows.
#pragma once

#include <cstdint>
#include <span>

#include "base/parallel_for.h"
#include "formats/images/palette.h"
#include "render/frame_buffer.h"

namespace temblor::render {

// Writes 0xffRRGGBB for each pixel to `out`, which must have frame.pixel_count() elements (CHECKed). Indexed
// frames are looked up in `palette`; rgb frames are copied. Rows are divided among `jobs`.
void present(const FrameBuffer& frame, const formats::Palette& palette, bool simd_kernels, base::Jobs& jobs,
             std::span<std::uint32_t> out);

}  // namespace temblor::render
