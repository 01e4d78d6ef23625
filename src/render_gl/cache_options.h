// The memory of the card for what the CPU has built, and how a frame used it.
#pragma once

#include <cstddef>
#include <cstdint>

namespace temblor::render_gl {

// How texels are kept. 16 bits: 5, 6, and 5 for the colors, rounded when a texel is uploaded, and clear
// texels have a color of their own, as VQuake's time had it (a color key). The CPU's blocks always have 32
// bits. 8 bits: palette indices, for indexed frames, whatever was asked for.
//
// kLight: samples of light, three numbers of 10 bits, which the card interpolates.
enum class TexelFormat { k32Bit, k16Bit, k8Bit, kLight };

struct CacheOptions {
  // A frame that needs more is drawn in portions. Less than two layers of 64 x 64 texels counts as those.
  // Images that are larger than a layer are kept at a half or less of their size: with 2 MB of 32 bits, those
  // above 512 texels. Indexed frames take a quarter of it.
  std::size_t bytes = std::size_t{64} << 20;  // surfaces of a frame of 3840x2160 take 20 to 40 MB
  TexelFormat format = TexelFormat::k32Bit;
};

// Counts of one frame. An image is a surface block, or a texture that repeats.
struct CacheCounts {
  std::uint32_t hits = 0;      // images that were there, each counted once in a portion
  std::uint32_t uploads = 0;   // images that were missing or had changed
  std::uint32_t evicted = 0;   // images that made room for others
  std::uint32_t portions = 0;  // the cache was filled so often; 1 if the frame fits
  std::uint64_t bytes_uploaded = 0;
  std::uint32_t drawn = 0;  // blocks that the card drew itself, because they were missing
};

}  // namespace temblor::render_gl
