#include "support/pictures/frames.h"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <cstring>
#include <span>

namespace temblor::test {
namespace {

// Four independent lanes, so that hundreds of millions of pixels take only seconds.
std::uint64_t hash_bytes(std::span<const std::byte> bytes, std::uint64_t seed) {
  constexpr std::uint64_t kOdd = 0x9fb21c651e98df25u;
  std::uint64_t lanes[4] = {seed, seed + 1, seed + 2, seed + 3};
  std::size_t at = 0;
  for (; at + sizeof lanes <= bytes.size(); at += sizeof lanes) {
    std::uint64_t words[4];
    std::memcpy(words, bytes.data() + at, sizeof words);
    for (int i = 0; i < 4; ++i) lanes[i] = std::rotl((lanes[i] ^ words[i]) * kOdd, 31);
  }
  std::uint64_t hash = bytes.size();
  for (const std::uint64_t lane : lanes) hash = std::rotl((hash ^ lane) * kOdd, 29);
  for (; at < bytes.size(); ++at) hash = std::rotl((hash ^ static_cast<std::uint64_t>(bytes[at])) * kOdd, 29);
  return hash;
}

}  // namespace

void fill_frame(render::FrameBuffer& io_frame, std::uint8_t byte) {
  const auto fill = [byte](auto pixels) {
    if (!pixels.empty()) std::memset(pixels.data(), byte, pixels.size_bytes());
  };
  fill(io_frame.indexed());
  fill(io_frame.rgb());
  fill(io_frame.depth());
}

FrameCopy copy_picture(const render::FrameBuffer& frame) {
  FrameCopy copy;
  copy.indexed.assign(frame.indexed().begin(), frame.indexed().end());
  copy.rgb.assign(frame.rgb().begin(), frame.rgb().end());
  for (const float depth : frame.depth()) copy.depth_bits.push_back(std::bit_cast<std::uint32_t>(depth));
  return copy;
}

std::size_t differing_pixels(const FrameCopy& a, const FrameCopy& b) {
  std::size_t differing = 0;
  for (std::size_t i = 0; i < a.depth_bits.size(); ++i) {
    const bool same_color = a.indexed.empty() ? a.rgb[i] == b.rgb[i] : a.indexed[i] == b.indexed[i];
    if (!same_color || a.depth_bits[i] != b.depth_bits[i]) ++differing;
  }
  return differing;
}

int largest_difference(std::uint32_t a, std::uint32_t b) {
  int largest = 0;
  for (int shift = 0; shift < 24; shift += 8)
    largest =
        std::max(largest, std::abs(static_cast<int>(a >> shift & 255) - static_cast<int>(b >> shift & 255)));
  return largest;
}

double equal_share(std::span<const std::uint32_t> a, std::span<const std::uint32_t> b, int tolerance) {
  if (a.size() != b.size()) return 0;
  std::size_t equal = 0;
  for (std::size_t i = 0; i < a.size(); ++i) equal += largest_difference(a[i], b[i]) <= tolerance;
  return static_cast<double>(equal) / static_cast<double>(a.size());
}

std::uint64_t compute_hash(const render::FrameBuffer& frame) {
  std::uint64_t hash = hash_bytes(std::as_bytes(frame.indexed()), 1);
  hash = hash_bytes(std::as_bytes(frame.rgb()), hash);
  return hash_bytes(std::as_bytes(frame.depth()), hash);
}

}  // namespace temblor::test
