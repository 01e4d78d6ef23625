// Hot loop. The SIMD version of sprite_kernels_scalar.cpp, compiled once for each instruction set.
#include "lab/models/sprite_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "lab/models/sprite_kernels_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace temblor::lab::HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR

void DrawSpriteU8(const SpriteRows& rows) {
  draw_sprite_u8_scalar(rows);
}
void DrawSpriteU32(const SpriteRows& rows) {
  draw_sprite_u32_scalar(rows);
}

#else

namespace hn = hwy::HWY_NAMESPACE;

using DF = hn::CappedTag<float, 16>;
using DI = hn::RebindToSigned<DF>;

HWY_INLINE void CopyPixels(hn::Mask<DF> nearer, const uint32_t* from, uint32_t* to) {
  const hn::RebindToUnsigned<DF> d;
  hn::BlendedStore(hn::LoadU(d, from), hn::RebindMask(d, nearer), d, to);
}

HWY_INLINE void CopyPixels(hn::Mask<DF> nearer, const uint8_t* from, uint8_t* to) {
  const hn::Rebind<int8_t, DF> narrow;
  const hn::Rebind<uint8_t, DF> d;
  const auto mask = hn::BitCast(d, hn::DemoteTo(narrow, hn::VecFromMask(DI(), hn::RebindMask(DI(), nearer))));
  const auto pixels = hn::IfThenElse(hn::MaskFromVec(mask), hn::LoadU(d, from), hn::LoadU(d, to));
  hn::StoreU(pixels, d, to);
}

template <typename Pixel>
HWY_INLINE void DrawSprite(const SpriteRows& rows) {
  const DF d;
  const auto lanes = static_cast<int32_t>(hn::Lanes(d));
  const auto scale = hn::Set(d, rows.depth_scale);
  for (int32_t y = 0; y < rows.height; ++y) {
    const Pixel* const from = static_cast<const Pixel*>(rows.pixels) + y * rows.stride;
    const float* const depth = rows.depth + y * rows.stride;
    Pixel* const to = static_cast<Pixel*>(rows.out_pixels) + y * rows.out_stride;
    float* const nearest = rows.out_depth + y * rows.out_stride;
    int32_t x = 0;
    for (; x + lanes <= rows.width; x += lanes) {
      const auto moved = hn::Mul(hn::LoadU(d, depth + x), scale);
      const auto nearer = hn::Ge(moved, hn::LoadU(d, nearest + x));
      if (hn::AllFalse(d, nearer)) continue;
      hn::BlendedStore(moved, nearer, d, nearest + x);
      CopyPixels(nearer, from + x, to + x);
    }
    for (; x < rows.width; ++x) {
      const float moved = depth[x] * rows.depth_scale;
      if (!(moved >= nearest[x])) continue;
      nearest[x] = moved;
      to[x] = from[x];
    }
  }
}

void DrawSpriteU8(const SpriteRows& rows) {
  DrawSprite<uint8_t>(rows);
}
void DrawSpriteU32(const SpriteRows& rows) {
  DrawSprite<uint32_t>(rows);
}

#endif

}  // namespace temblor::lab::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace temblor::lab {

HWY_EXPORT(DrawSpriteU8);
HWY_EXPORT(DrawSpriteU32);

void draw_sprite_u8_simd(const SpriteRows& rows) {
  HWY_DYNAMIC_DISPATCH(DrawSpriteU8)(rows);
}
void draw_sprite_u32_simd(const SpriteRows& rows) {
  HWY_DYNAMIC_DISPATCH(DrawSpriteU32)(rows);
}

}  // namespace temblor::lab
#endif
