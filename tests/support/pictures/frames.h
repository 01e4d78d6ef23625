// Telling frames apart: filled before they are drawn to, compared after.
#pragma once

#include <cstdint>
#include <vector>

#include "render/frame.h"

namespace temblor::test {

// Every byte of pixels and depth.
void fill_frame(render::FrameBuffer& io_frame, std::uint8_t byte);

// What a frame shows, owned: to be compared with that of another.
struct FrameCopy {
  std::vector<std::uint8_t> indexed;
  std::vector<std::uint32_t> rgb;
  std::vector<std::uint32_t> depth_bits;
  bool operator==(const FrameCopy&) const = default;
};
FrameCopy copy_of(const render::FrameBuffer& frame);

// How many pixels differ in color or depth; the frames have one size.
std::size_t differing_pixels(const FrameCopy& a, const FrameCopy& b);

// A hash of pixels and depth, for frames too large to be kept twice.
std::uint64_t hash_of(const render::FrameBuffer& frame);

}  // namespace temblor::test
