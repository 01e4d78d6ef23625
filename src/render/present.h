// Converts a frame to the 32-bit pixels that a window or a video file shows.
#pragma once

#include <cstdint>
#include <span>

#include "base/parallel_for.h"
#include "formats/images/palette.h"
#include "render/frame_buffer.h"

namespace temblor::render {

// The palette that shows an indexed frame: `palette` with the frame's tint. Like stock Quake's change of the
// display's palette, it is exact, costs nothing, and tints the status bar and menus, too.
formats::Palette shown_palette(const FrameBuffer& frame, const formats::Palette& palette);

// Writes 0xffRRGGBB for each pixel to `out`, which must have frame.pixel_count() elements (CHECKed). Indexed
// frames are looked up in `palette`, to which the caller has applied the tint; rgb frames are copied. Rows
// are divided among `jobs`.
void present(const FrameBuffer& frame, const formats::Palette& palette, bool simd_kernels, base::Jobs& jobs,
             std::span<std::uint32_t> out);

}  // namespace temblor::render
