// Compares frames: fills them before something draws to them, and compares the results.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/frame_buffer.h"

namespace temblor::test {

// Fills every byte of pixels and depth.
void fill_frame(render::FrameBuffer& io_frame, std::uint8_t byte);

// A copy of the contents of a frame, for comparison with another one.
struct FrameCopy {
  std::vector<std::uint8_t> indexed;
  std::vector<std::uint32_t> rgb;
  std::vector<std::uint32_t> depth_bits;
  bool operator==(const FrameCopy&) const = default;
};
FrameCopy copy_picture(const render::FrameBuffer& frame);

// Counts the pixels that differ in color or depth. The frames must have the same size.
std::size_t differing_pixels(const FrameCopy& a, const FrameCopy& b);

// The largest difference of two colors' channels.
int largest_difference(std::uint32_t a, std::uint32_t b);

// The share of pixels whose channels differ by at most `tolerance`; 0 for pictures of different sizes.
double equal_share(std::span<const std::uint32_t> a, std::span<const std::uint32_t> b, int tolerance);

// A hash of pixels and depth, for frames that are too large to keep two of.
std::uint64_t compute_hash(const render::FrameBuffer& frame);

}  // namespace temblor::test
