// The SIMD versions of build_kernels_scalar.cpp, compiled once for each instruction set.
#include "render/surfaces/build_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/surfaces/build_kernels_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace temblor::render::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET == HWY_SCALAR

void BuildIndexedRow(const IndexedRow& row) {
  build_indexed_row_scalar(row);
}
void BuildRgbRow(const RgbRow& row) {
  build_rgb_row_scalar(row);
}

#else

// 0, 1, 2, ... times `step`, wrapping every `period` lanes (a power of two).
template <class D>
// 0, 1, 2, ... times `step`, starting again every `period` lanes (a power of two).
HWY_INLINE hn::Vec<D> Fractions(D d, int period, int step) {
  const auto lane = hn::And(hn::Iota(d, 0), hn::Set(d, static_cast<int16_t>(period - 1)));
  return hn::Mul(lane, hn::Set(d, static_cast<int16_t>(step)));
}

// One sample interval at a time. Light and table positions are computed in vectors; the colormap is looked up
// one texel at a time.
void BuildIndexedRow(const IndexedRow& row) {
  const hn::CappedTag<int16_t, 16> d;
  const hn::Rebind<uint8_t, decltype(d)> d8;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const int step = 32768 / row.texels_per_sample;
  HWY_ALIGN int16_t positions[16];
  for (int x = 0, column = 0; x < row.count; x += row.texels_per_sample, ++column) {
    const auto from = hn::Set(d, row.light[column]);
    const auto change = hn::Set(d, static_cast<int16_t>(row.light[column + 1] - row.light[column]));
    const int texels = row.texels_per_sample < row.count - x ? row.texels_per_sample : row.count - x;
    for (int i = 0; i < texels; i += lanes) {
      const auto fraction = hn::Add(Fractions(d, 16, step), hn::Set(d, static_cast<int16_t>(i * step)));
      const auto light = hn::Add(from, hn::MulFixedPoint15(change, fraction));
      const auto colors = hn::PromoteTo(d, hn::LoadU(d8, row.texels + x + i));
      hn::Store(hn::Add(hn::AndNot(hn::Set(d, 255), light), colors), d, positions);
      const int last = texels - i < lanes ? texels - i : lanes;
      for (int lane = 0; lane < last; ++lane) row.out[x + i + lane] = row.colormap[positions[lane]];
    }
  }
}

// Four 16-bit channels per texel. A vector never crosses a sample column, so both light values are the same
// in all of its texels.
template <class D>
HWY_INLINE void BuildRgbTexels(D d, const RgbRow& row) {
  const hn::Rebind<uint8_t, D> d8;
  const hn::Repartition<uint32_t, decltype(d8)> d32;
  const hn::Repartition<int64_t, D> d64;
  const int texels_per_vector = static_cast<int>(hn::Lanes(d)) / 4;
  const auto opaque = hn::Set(d, 255);
  const auto alpha = hn::Set(d32, 0xff000000u);
  const int step = 32768 / row.texels_per_sample;
  // The fractions of the first vector after a sample column, one per channel.
  const auto first_fractions =
      hn::Mul(hn::ShiftRight<2>(hn::Iota(d, 0)), hn::Set(d, static_cast<int16_t>(step)));
  const int16_t* sample = row.light;
  for (int x = 0; x < row.count; x += row.texels_per_sample, sample += 4) {
    int64_t here, next;
    __builtin_memcpy(&here, sample, sizeof(here));
    __builtin_memcpy(&next, sample + 4, sizeof(next));
    const auto from = hn::BitCast(d, hn::Set(d64, here));
    const auto change = hn::Sub(hn::BitCast(d, hn::Set(d64, next)), from);
    for (int i = 0; i < row.texels_per_sample && x + i < row.count; i += texels_per_vector) {
      const auto fractions = hn::Add(first_fractions, hn::Set(d, static_cast<int16_t>(i * step)));
      const auto light = hn::Add(from, hn::MulFixedPoint15(change, fractions));
      const auto texels = hn::LoadU(d8, reinterpret_cast<const uint8_t*>(row.texels + x + i));
      const auto colors = hn::PromoteTo(d, texels);
      const auto lit = hn::Min(hn::MulFixedPoint15(hn::Add(colors, colors), light), opaque);
      const auto shaded = hn::BitCast(d32, hn::DemoteTo(d8, lit));
      const auto as_is = hn::BitCast(d32, texels);
      const auto full_bright = hn::Eq(hn::And(as_is, alpha), hn::Zero(d32));
      const auto out = hn::Or(hn::IfThenElse(full_bright, as_is, shaded), alpha);
      if (HWY_LIKELY(x + i + texels_per_vector <= row.count)) {
        hn::StoreU(out, d32, row.out + x + i);
      } else {
        HWY_ALIGN uint32_t last[8];
        hn::Store(out, d32, last);
        for (int j = 0; j < texels_per_vector && x + i + j < row.count; ++j) row.out[x + i + j] = last[j];
      }
    }
  }
}

void BuildRgbRow(const RgbRow& row) {
  if (row.texels_per_sample >= 8)
    BuildRgbTexels(hn::CappedTag<int16_t, 32>(), row);  // NOLINT(bugprone-branch-clone): short vectors
  else if (row.texels_per_sample == 4)
    BuildRgbTexels(hn::CappedTag<int16_t, 16>(), row);
  else
    BuildRgbTexels(hn::CappedTag<int16_t, 8>(), row);
}

#endif

}  // namespace temblor::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace temblor::render {

HWY_EXPORT(BuildIndexedRow);
HWY_EXPORT(BuildRgbRow);

void build_indexed_row_simd(const IndexedRow& row) {
  HWY_DYNAMIC_DISPATCH(BuildIndexedRow)(row);
}
void build_rgb_row_simd(const RgbRow& row) {
  HWY_DYNAMIC_DISPATCH(BuildRgbRow)(row);
}

}  // namespace temblor::render
#endif
