// The SIMD version of present_kernels_scalar.cpp, compiled once for each instruction set.
#include "render/screen/present_kernels.h"

// Processors with lookups in tables of 128 bytes (AVX-512 VBMI) deserve a target of their own here.
#define HWY_WANT_AVX3_DL 1

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/screen/present_kernels_simd.cpp"
#include <hwy/cache_control.h>
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace temblor::render::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET == HWY_AVX3_DL

// One color channel of the palette, 256 bytes in four registers.
struct ChannelTable {
  __m512i quarter[4];

  HWY_INLINE void Load(const uint32_t* colors, int shift) {
    HWY_ALIGN uint8_t bytes[256];
    for (int i = 0; i < 256; ++i) bytes[i] = static_cast<uint8_t>(colors[i] >> shift);
    for (int i = 0; i < 4; ++i) quarter[i] = _mm512_load_si512(bytes + 64 * i);
  }
  HWY_INLINE __m512i Look(__m512i indices, __mmask64 upper_half) const {
    const __m512i lower = _mm512_permutex2var_epi8(quarter[0], indices, quarter[1]);
    const __m512i upper = _mm512_permutex2var_epi8(quarter[2], indices, quarter[3]);
    return _mm512_mask_blend_epi8(upper_half, lower, upper);
  }
};

HWY_INLINE void Stream(__m512i pixels, uint32_t* out) {
  _mm512_stream_si512(reinterpret_cast<__m512i*>(out), pixels);
}

// Expands 64 pixels at a time: looks up each channel separately, then interleaves the channels. Returns the
// number of pixels expanded.
HWY_INLINE size_t ExpandVectors(const uint8_t* HWY_RESTRICT indices, size_t count,
                                const uint32_t* HWY_RESTRICT colors, uint32_t* HWY_RESTRICT out) {
  ChannelTable blue, green, red, alpha;
  blue.Load(colors, 0);
  green.Load(colors, 8);
  red.Load(colors, 16);
  alpha.Load(colors, 24);
  // Interleaving works within 128-bit blocks, so pixels are first distributed to the block that will output
  // them.
  const __m512i dealt = _mm512_setr_epi32(0, 4, 8, 12, 1, 5, 9, 13, 2, 6, 10, 14, 3, 7, 11, 15);
  size_t i = 0;
  for (; i + 64 <= count; i += 64) {
    const __m512i pixels = _mm512_permutexvar_epi32(dealt, _mm512_loadu_si512(indices + i));
    const __mmask64 upper_half = _mm512_movepi8_mask(pixels);
    const __m512i b = blue.Look(pixels, upper_half), g = green.Look(pixels, upper_half);
    const __m512i r = red.Look(pixels, upper_half), a = alpha.Look(pixels, upper_half);
    const __m512i bg_low = _mm512_unpacklo_epi8(b, g), bg_high = _mm512_unpackhi_epi8(b, g);
    const __m512i ra_low = _mm512_unpacklo_epi8(r, a), ra_high = _mm512_unpackhi_epi8(r, a);
    Stream(_mm512_unpacklo_epi16(bg_low, ra_low), out + i);
    Stream(_mm512_unpackhi_epi16(bg_low, ra_low), out + i + 16);
    Stream(_mm512_unpacklo_epi16(bg_high, ra_high), out + i + 32);
    Stream(_mm512_unpackhi_epi16(bg_high, ra_high), out + i + 48);
  }
  return i;
}

#else

HWY_INLINE size_t ExpandVectors(const uint8_t* HWY_RESTRICT indices, size_t count,
                                const uint32_t* HWY_RESTRICT colors, uint32_t* HWY_RESTRICT out) {
  const hn::CappedTag<uint32_t, 16> d;
  const hn::Rebind<int32_t, decltype(d)> di;
  const hn::Rebind<uint8_t, decltype(d)> d8;
  const size_t lanes = hn::Lanes(d);
  size_t i = 0;
  for (; i + lanes <= count; i += lanes) {
    const auto positions = hn::PromoteTo(di, hn::LoadU(d8, indices + i));
    hn::Stream(hn::GatherIndex(d, colors, positions), d, out + i);
  }
  return i;
}

#endif

// Whole cache lines of `out` are written with streaming stores, which bypass the caches: this program never
// reads the window's pixels, and the caches keep what the next frame needs.
void ExpandPalette(const uint8_t* HWY_RESTRICT indices, size_t count, const uint32_t* HWY_RESTRICT colors,
                   uint32_t* HWY_RESTRICT out) {
  constexpr size_t kLinePixels = 64 / sizeof(uint32_t);
  const size_t into_line = reinterpret_cast<uintptr_t>(out) / sizeof(uint32_t) % kLinePixels;
  const size_t head = HWY_MIN(count, (kLinePixels - into_line) % kLinePixels);
  size_t i = 0;
  for (; i < head; ++i) out[i] = colors[indices[i]];
  i += ExpandVectors(indices + head, count - head, colors, out + head);
  hwy::FlushStream();
  for (; i < count; ++i) out[i] = colors[indices[i]];
}

}  // namespace temblor::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace temblor::render {

HWY_EXPORT(ExpandPalette);

void expand_palette_simd(const std::uint8_t* indices, std::size_t count, const std::uint32_t* colors,
                         std::uint32_t* out) {
  HWY_DYNAMIC_DISPATCH(ExpandPalette)(indices, count, colors, out);
}

}  // namespace temblor::render
#endif
