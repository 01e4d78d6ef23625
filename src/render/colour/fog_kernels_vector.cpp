// Hot loop. The vector twins of fog_kernels_plain.cpp, compiled once for each instruction set.
#include "render/colour/fog_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/colour/fog_kernels_vector.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace temblor::render::HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR

void FogRowU8(const FogRow& row) {
  fog_row_u8_plain(row);
}
void FogRowU32(const FogRow& row) {
  fog_row_u32_plain(row);
}

#else

namespace hn = hwy::HWY_NAMESPACE;

using DF = hn::CappedTag<float, 16>;
using DI = hn::Rebind<int32_t, DF>;
using DU = hn::RebindToUnsigned<DI>;
using D16 = hn::Repartition<uint16_t, DU>;
using D8 = hn::Rebind<uint8_t, DU>;

// In `steps`ths, from pixel i on, whose depth is the first of `depths`.
HWY_INLINE hn::Vec<DI> StepsAt(const FogRow& row, int i, const float* depths, int steps) {
  const DF d;
  const DI di;
  const auto depth = hn::LoadU(d, depths);
  const auto z = row.perspective ? hn::Div(hn::Set(d, 1.0f), hn::Max(depth, hn::Set(d, kFarthestInFog)))
                                 : hn::Neg(depth);
  const auto thickness = hn::Mul(hn::Set(d, row.rate), z);
  const auto squared = hn::Mul(thickness, thickness);
  const auto turns = hn::Mul(hn::Min(squared, hn::Set(d, kMostFog)), hn::Set(d, kLog2E));
  const auto whole = hn::Floor(turns);
  const auto r = hn::Sub(turns, whole);
  auto series = hn::Set(d, kExpSeries[4]);
  for (int term = 3; term >= 0; --term) series = hn::Add(hn::Mul(series, r), hn::Set(d, kExpSeries[term]));
  const auto exponent = hn::ShiftLeft<23>(hn::Sub(hn::Set(di, 127), hn::ConvertTo(di, whole)));
  const auto left = hn::Mul(hn::Add(hn::Mul(series, r), hn::Set(d, 1.0f)), hn::BitCast(d, exponent));
  const auto share = hn::Sub(hn::Set(d, 1.0f), left);
  const auto in_steps =
      hn::ConvertTo(di, hn::Add(hn::Mul(share, hn::Set(d, static_cast<float>(steps))), hn::Set(d, 0.5f)));
  const auto lane = hn::Add(hn::Iota(d, 0.0f), hn::Set(d, static_cast<float>(i)));
  const auto sky = hn::Add(hn::Set(d, row.sky), hn::Mul(lane, hn::Set(d, row.sky_step)));
  return hn::IfThenElse(hn::RebindMask(di, hn::Eq(depth, sky)), hn::Set(di, row.sky_share * steps / 256),
                        in_steps);
}

// One vector of pixels, from pixel i on.
HWY_INLINE void FogPixels(const FogRow& row, int i, const float* depths, uint8_t* pixels) {
  const DI di;
  const D8 d8;
  constexpr int kLanes = static_cast<int>(hn::MaxLanes(DI()));
  const uint8_t* const rows = row.rows;
  HWY_ALIGN int32_t index[16];
  HWY_ALIGN uint8_t fogged[16];
  const auto under = hn::PromoteTo(di, hn::LoadU(d8, pixels));
  hn::Store(hn::Add(hn::ShiftLeft<8>(StepsAt(row, i, depths, 64)), under), di, index);
  // One by one: a gather of bytes is slower.
  for (int lane = 0; lane < kLanes; ++lane) fogged[lane] = rows[index[lane]];
  hn::StoreU(hn::Load(d8, fogged), d8, pixels);
}

HWY_INLINE void FogPixels(const FogRow& row, int i, const float* depths, uint32_t* pixels) {
  const DU du;
  const D16 d16;
  // Two channels at a time, in the halves of a lane.
  const auto two = hn::Set(du, 0x00ff00ffu);
  const auto round = hn::Set(d16, 128);
  const auto low_fog = hn::BitCast(d16, hn::Set(du, row.colour & 0x00ff00ffu));
  const auto high_fog = hn::BitCast(d16, hn::Set(du, row.colour >> 8 & 0xffu));
  const auto fog_steps = hn::BitCast(du, StepsAt(row, i, depths, 256));
  const auto fog = hn::BitCast(d16, hn::Or(fog_steps, hn::ShiftLeft<16>(fog_steps)));
  const auto rest = hn::Sub(hn::Set(d16, 256), fog);
  const auto under = hn::LoadU(du, pixels);
  const auto low = hn::BitCast(d16, hn::And(under, two));
  const auto high = hn::BitCast(d16, hn::And(hn::ShiftRight<8>(under), hn::Set(du, 0xff)));
  const auto low_sum = hn::Add(hn::Add(hn::Mul(low_fog, fog), hn::Mul(low, rest)), round);
  const auto high_sum = hn::Add(hn::Add(hn::Mul(high_fog, fog), hn::Mul(high, rest)), round);
  const auto low_out = hn::And(hn::ShiftRight<8>(hn::BitCast(du, low_sum)), two);
  const auto high_out = hn::And(hn::BitCast(du, high_sum), hn::Set(du, 0xff00));
  const auto alpha = hn::And(under, hn::Set(du, 0xff000000u));
  hn::StoreU(hn::Or(hn::Or(low_out, high_out), alpha), du, pixels);
}

template <typename Pixel>
HWY_INLINE void FogWholeRow(const FogRow& row) {
  constexpr int kLanes = static_cast<int>(hn::MaxLanes(DI()));
  auto* const pixels = static_cast<Pixel*>(row.pixels);
  int i = 0;
  for (; i + kLanes <= row.count; i += kLanes) FogPixels(row, i, row.depth + i, pixels + i);
  if (i == row.count) return;
  // The last ones beside the row: there may be nothing to read behind them.
  HWY_ALIGN float last_depths[16] = {};
  HWY_ALIGN Pixel last[16] = {};
  for (int j = i; j < row.count; ++j) {
    last_depths[j - i] = row.depth[j];
    last[j - i] = pixels[j];
  }
  FogPixels(row, i, last_depths, last);
  for (int j = i; j < row.count; ++j) pixels[j] = last[j - i];
}

void FogRowU8(const FogRow& row) {
  FogWholeRow<uint8_t>(row);
}
void FogRowU32(const FogRow& row) {
  FogWholeRow<uint32_t>(row);
}

#endif

}  // namespace temblor::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace temblor::render {

HWY_EXPORT(FogRowU8);
HWY_EXPORT(FogRowU32);

void fog_row_u8_vector(const FogRow& row) {
  HWY_DYNAMIC_DISPATCH(FogRowU8)(row);
}
void fog_row_u32_vector(const FogRow& row) {
  HWY_DYNAMIC_DISPATCH(FogRowU32)(row);
}

}  // namespace temblor::render
#endif
