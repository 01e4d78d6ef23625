// Hot loop. The SIMD versions of merge_kernels_scalar.cpp, compiled once for each instruction set.
#include "render/translucent/merge_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/translucent/merge_kernels_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace temblor::render::HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR

void MergeOpaqueU8(const MergeRow& row) {
  merge_opaque_u8_scalar(row);
}
void MergeOpaqueU32(const MergeRow& row) {
  merge_opaque_u32_scalar(row);
}
void MergeBlendU8(const MergeRow& row) {
  merge_blend_u8_scalar(row);
}
void MergeBlendU32(const MergeRow& row) {
  merge_blend_u32_scalar(row);
}

#else

namespace hn = hwy::HWY_NAMESPACE;

using DF = hn::CappedTag<float, 16>;
using DI = hn::Rebind<int32_t, DF>;
using DU = hn::RebindToUnsigned<DI>;
using D16 = hn::Repartition<uint16_t, DU>;
using D8 = hn::Rebind<uint8_t, DU>;
using Mask = hn::Mask<DU>;

// The pixels that pass the depth test.
HWY_INLINE Mask InFront(const MergeRow& row, int i) {
  const DF d;
  const auto depth = hn::Mul(hn::LoadU(d, row.depth + i), hn::Set(d, row.nearer));
  return hn::RebindMask(DU(), hn::Ge(depth, hn::LoadU(d, row.z + i)));
}

// Remove clear texels from `shown`.
HWY_INLINE Mask NotClearBytes(const MergeRow& row, hn::Vec<DU> texels, Mask shown) {
  return row.has_holes ? hn::And(shown, hn::Ne(texels, hn::Set(DU(), 255))) : shown;
}
HWY_INLINE Mask NotClearColors(const MergeRow& row, hn::Vec<DU> texels, Mask shown) {
  return row.has_holes ? hn::And(shown, hn::Ne(hn::ShiftRight<24>(texels), hn::Zero(DU()))) : shown;
}

HWY_INLINE void WriteDepth(const MergeRow& row, int i, Mask shown) {
  const DF d;
  const auto depth = hn::LoadU(d, row.depth + i), z = hn::LoadU(d, row.z + i);
  hn::StoreU(hn::IfThenElse(hn::RebindMask(d, shown), depth, z), d, row.z + i);
}

HWY_INLINE hn::Vec<DU> LoadBytes(const void* bytes, int i) {
  return hn::PromoteTo(DU(), hn::LoadU(D8(), static_cast<const uint8_t*>(bytes) + i));
}
HWY_INLINE void StoreBytes(hn::Vec<DU> v, void* bytes, int i) {
  hn::StoreU(hn::TruncateTo(D8(), v), D8(), static_cast<uint8_t*>(bytes) + i);
}

void MergeOpaqueU8(const MergeRow& row) {
  const DU du;
  const int lanes = static_cast<int>(hn::Lanes(du));
  int i = 0;
  for (; i + lanes <= row.count; i += lanes) {
    const auto texels = LoadBytes(row.texels, i);
    const auto shown = NotClearBytes(row, texels, InFront(row, i));
    if (hn::AllFalse(du, shown)) continue;
    StoreBytes(hn::IfThenElse(shown, texels, LoadBytes(row.pixels, i)), row.pixels, i);
    WriteDepth(row, i, shown);
  }
  merge_opaque_u8_scalar(row, i);
}

void MergeOpaqueU32(const MergeRow& row) {
  const DU du;
  const int lanes = static_cast<int>(hn::Lanes(du));
  auto* const pixels = static_cast<uint32_t*>(row.pixels);
  int i = 0;
  for (; i + lanes <= row.count; i += lanes) {
    const auto texels = hn::LoadU(du, static_cast<const uint32_t*>(row.texels) + i);
    const auto shown = NotClearColors(row, texels, InFront(row, i));
    if (hn::AllFalse(du, shown)) continue;
    hn::StoreU(hn::IfThenElse(shown, texels, hn::LoadU(du, pixels + i)), du, pixels + i);
    WriteDepth(row, i, shown);
  }
  merge_opaque_u32_scalar(row, i);
}

void MergeBlendU8(const MergeRow& row) {
  const DU du;
  const int lanes = static_cast<int>(hn::Lanes(du));
  HWY_ALIGN uint32_t index[16];
  HWY_ALIGN uint8_t blended[16];
  int i = 0;
  for (; i + lanes <= row.count; i += lanes) {
    const auto texels = LoadBytes(row.texels, i);
    const auto shown = NotClearBytes(row, texels, InFront(row, i));
    if (hn::AllFalse(du, shown)) continue;
    const auto under = LoadBytes(row.pixels, i);
    // The table is looked up one pixel at a time: a gather of bytes is slower.
    hn::Store(hn::Add(hn::ShiftLeft<8>(texels), under), du, index);
    for (int lane = 0; lane < lanes; ++lane) blended[lane] = row.table[index[lane]];
    StoreBytes(hn::IfThenElse(shown, LoadBytes(blended, 0), under), row.pixels, i);
  }
  merge_blend_u8_scalar(row, i);
}

void MergeBlendU32(const MergeRow& row) {
  const DU du;
  const D16 d16;
  const int lanes = static_cast<int>(hn::Lanes(du));
  auto* const pixels = static_cast<uint32_t*>(row.pixels);
  const auto over = hn::Set(d16, static_cast<uint16_t>(row.opacity_256));
  const auto rest = hn::Set(d16, static_cast<uint16_t>(256 - row.opacity_256));
  const auto round = hn::Set(d16, 128);
  // Two channels at a time, in the halves of a lane.
  const auto two = hn::Set(du, 0x00ff00ffu), one = hn::Set(du, 0xffu);
  int i = 0;
  for (; i + lanes <= row.count; i += lanes) {
    const auto texels = hn::LoadU(du, static_cast<const uint32_t*>(row.texels) + i);
    const auto shown = NotClearColors(row, texels, InFront(row, i));
    if (hn::AllFalse(du, shown)) continue;
    const auto under = hn::LoadU(du, pixels + i);
    const auto low = hn::Add(hn::Mul(hn::BitCast(d16, hn::And(texels, two)), over),
                             hn::Mul(hn::BitCast(d16, hn::And(under, two)), rest));
    const auto high = hn::Add(hn::Mul(hn::BitCast(d16, hn::And(hn::ShiftRight<8>(texels), one)), over),
                              hn::Mul(hn::BitCast(d16, hn::And(hn::ShiftRight<8>(under), one)), rest));
    const auto low_out = hn::And(hn::ShiftRight<8>(hn::BitCast(du, hn::Add(low, round))), two);
    const auto high_out = hn::And(hn::BitCast(du, hn::Add(high, round)), hn::Set(du, 0xff00u));
    const auto blended = hn::Or(hn::Or(low_out, high_out), hn::Set(du, 0xff000000u));
    hn::StoreU(hn::IfThenElse(shown, blended, under), du, pixels + i);
  }
  merge_blend_u32_scalar(row, i);
}

#endif

}  // namespace temblor::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace temblor::render {

HWY_EXPORT(MergeOpaqueU8);
HWY_EXPORT(MergeOpaqueU32);
HWY_EXPORT(MergeBlendU8);
HWY_EXPORT(MergeBlendU32);

void merge_opaque_u8_simd(const MergeRow& row) {
  HWY_DYNAMIC_DISPATCH(MergeOpaqueU8)(row);
}
void merge_opaque_u32_simd(const MergeRow& row) {
  HWY_DYNAMIC_DISPATCH(MergeOpaqueU32)(row);
}
void merge_blend_u8_simd(const MergeRow& row) {
  HWY_DYNAMIC_DISPATCH(MergeBlendU8)(row);
}
void merge_blend_u32_simd(const MergeRow& row) {
  HWY_DYNAMIC_DISPATCH(MergeBlendU32)(row);
}

}  // namespace temblor::render
#endif
