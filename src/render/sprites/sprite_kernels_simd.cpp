// Hot loop. The SIMD versions of sprite_kernels_scalar.cpp, compiled once for each instruction set.
#include <cstring>

#include "render/sprites/sprite_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/sprites/sprite_kernels_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace temblor::render::HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR

void DrawSpriteRowU8(const SpriteRow& row) {
  draw_sprite_row_u8_scalar(row);
}
void DrawSpriteRowU32(const SpriteRow& row) {
  draw_sprite_row_u32_scalar(row);
}

#else

namespace hn = hwy::HWY_NAMESPACE;

using DF = hn::CappedTag<float, 16>;
using DI = hn::Rebind<int32_t, DF>;
using DU = hn::RebindToUnsigned<DI>;
using D8 = hn::Rebind<uint8_t, DU>;
using VF = hn::Vec<DF>;
using VI = hn::Vec<DI>;
using VU = hn::Vec<DU>;

constexpr int kMaxLanes = 16;
// A gather reads four texels, so it must begin at least four texels before the end of the picture. Pictures
// of fewer texels are left to the scalar version.
constexpr int kGatheredTexels = 4;

// A SpriteLine for a vector of pixels.
struct LanesOfLine {
  VF base, step;
  HWY_INLINE explicit LanesOfLine(const SpriteLine& line)
      : base(hn::Set(DF(), line.base)), step(hn::Set(DF(), line.step)) {}
  HWY_INLINE VF At(VF i) const { return hn::Add(base, hn::Mul(i, step)); }
};

// The constants of a row, each in every lane. They stay in registers, although stores of pixels may alias
// memory.
struct Row {
  LanesOfLine depth, s, t;
  VF last_s, last_t;
  VI width, last_gathered;
  const int32_t* texels;
  const uint32_t* colors;

  HWY_INLINE explicit Row(const SpriteRow& row)
      : depth(row.depth),
        s(row.s),
        t(row.t),
        last_s(hn::Set(DF(), static_cast<float>(row.width - 1))),
        last_t(hn::Set(DF(), static_cast<float>(row.height - 1))),
        width(hn::Set(DI(), row.width)),
        last_gathered(hn::Set(DI(), row.width * row.height - kGatheredTexels)),
        texels(reinterpret_cast<const int32_t*>(row.texels)),
        colors(row.colors) {}

  // Gathers four bytes that contain the texel, then shifts it down.
  HWY_INLINE VU GatherTexels(VI number) const {
    const DU du;
    const VI from = hn::Min(number, last_gathered);
    const VU four = hn::BitCast(du, hn::GatherOffset(DI(), texels, from));
    const VU bits = hn::BitCast(du, hn::ShiftLeft<3>(hn::Sub(number, from)));
    return hn::And(hn::Shr(four, bits), hn::Set(du, 255));
  }
};

HWY_INLINE VI TexelNumber(VF coordinate, VF last) {
  return hn::ConvertTo(DI(), hn::Min(hn::Max(coordinate, hn::Zero(DF())), last));
}

HWY_INLINE void StoreWhere(hn::Mask<DU> mask, VU texels, const uint32_t* colors, uint32_t* pixels) {
  const DU du;
  hn::BlendedStore(hn::GatherIndex(du, colors, hn::BitCast(DI(), texels)), mask, du, pixels);
}
HWY_INLINE void StoreWhere(hn::Mask<DU> mask, VU texels, const uint32_t*, uint8_t* pixels) {
  const DU du;
  const D8 d8;
  const VU old = hn::PromoteTo(du, hn::LoadU(d8, pixels));
  hn::StoreU(hn::TruncateTo(d8, hn::IfThenElse(mask, texels, old)), d8, pixels);
}

// Draws a vector of pixels; `place` is each pixel's position in the sprite's row.
template <bool kAffine, typename Pixel>
HWY_INLINE void DrawVector(const Row& row, VF place, Pixel* HWY_RESTRICT pixels,
                           float* HWY_RESTRICT frame_depth) {
  const DF d;
  const DU du;
  const VF depth = row.depth.At(place);
  const auto nearer = hn::Ge(depth, hn::LoadU(d, frame_depth));
  if (hn::AllFalse(d, nearer)) return;
  VF s = row.s.At(place), t = row.t.At(place);
  if constexpr (!kAffine) {
    const VF distance = hn::Div(hn::Set(d, 1.0f), hn::Max(depth, hn::Set(d, kMinSpriteDepth)));
    s = hn::Mul(s, distance);
    t = hn::Mul(t, distance);
  }
  const VI number = hn::Add(hn::Mul(TexelNumber(t, row.last_t), row.width), TexelNumber(s, row.last_s));
  const VU texels = row.GatherTexels(number);
  const auto shows = hn::And(hn::RebindMask(du, nearer), hn::Ne(texels, hn::Set(du, kClearTexel)));
  StoreWhere(shows, texels, row.colors, pixels);
  hn::BlendedStore(depth, hn::RebindMask(d, shows), d, frame_depth);
}

// The remainder of a row is drawn in a copy: pixels after it may belong to another thread.
template <bool kAffine, typename Pixel>
HWY_INLINE void DrawRow(const SpriteRow& sprite_row) {
  const DF d;
  const Row row(sprite_row);
  const int lanes = static_cast<int>(hn::Lanes(d)), count = sprite_row.count;
  Pixel* const pixels = static_cast<Pixel*>(sprite_row.pixels);
  float* const frame_depth = sprite_row.frame_depth;
  VF place = hn::Add(hn::Iota(d, 0), hn::Set(d, static_cast<float>(sprite_row.first)));
  const VF lanes_on = hn::Set(d, static_cast<float>(lanes));
  int first = 0;
  for (; first + lanes <= count; first += lanes, place = hn::Add(place, lanes_on))
    DrawVector<kAffine>(row, place, pixels + first, frame_depth + first);
  if (first == count) return;
  const size_t rest = static_cast<size_t>(count - first);
  HWY_ALIGN Pixel rest_pixels[kMaxLanes] = {};
  HWY_ALIGN float rest_depth[kMaxLanes] = {};
  std::memcpy(rest_pixels, pixels + first, rest * sizeof(Pixel));
  std::memcpy(rest_depth, frame_depth + first, rest * sizeof(float));
  DrawVector<kAffine>(row, place, rest_pixels, rest_depth);
  std::memcpy(pixels + first, rest_pixels, rest * sizeof(Pixel));
  std::memcpy(frame_depth + first, rest_depth, rest * sizeof(float));
}

void DrawSpriteRowU8(const SpriteRow& row) {
  if (row.width * row.height < kGatheredTexels)
    draw_sprite_row_u8_scalar(row);
  else if (row.affine)
    DrawRow<true, uint8_t>(row);
  else
    DrawRow<false, uint8_t>(row);
}
void DrawSpriteRowU32(const SpriteRow& row) {
  if (row.width * row.height < kGatheredTexels)
    draw_sprite_row_u32_scalar(row);
  else if (row.affine)
    DrawRow<true, uint32_t>(row);
  else
    DrawRow<false, uint32_t>(row);
}

#endif

}  // namespace temblor::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace temblor::render {

HWY_EXPORT(DrawSpriteRowU8);
HWY_EXPORT(DrawSpriteRowU32);

void draw_sprite_row_u8_simd(const SpriteRow& row) {
  HWY_DYNAMIC_DISPATCH(DrawSpriteRowU8)(row);
}
void draw_sprite_row_u32_simd(const SpriteRow& row) {
  HWY_DYNAMIC_DISPATCH(DrawSpriteRowU32)(row);
}

}  // namespace temblor::render
#endif
