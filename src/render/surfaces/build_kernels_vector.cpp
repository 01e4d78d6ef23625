// The vector twins of build_kernels_plain.cpp, compiled once for each instruction set.
#include "render/surfaces/build_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/surfaces/build_kernels_vector.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace temblor::render::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET == HWY_SCALAR

void BuildIndexedRow(const IndexedRow& row) {
  build_indexed_row_plain(row);
}
void BuildRgbRow(const RgbRow& row) {
  build_rgb_row_plain(row);
}

#else

// 0, 1, 2, ... times `step`, wrapping every `period` lanes (a power of two).
template <class D>
HWY_INLINE hn::Vec<D> Fractions(D d, int period, int step) {
  const auto lane = hn::And(hn::Iota(d, 0), hn::Set(d, static_cast<int16_t>(period - 1)));
  return hn::Mul(lane, hn::Set(d, static_cast<int16_t>(step)));
}

void BuildIndexedRow(const IndexedRow& row) {
  const hn::CappedTag<int16_t, 16> d;
  const hn::Rebind<uint8_t, decltype(d)> d8;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const int step = 32768 / row.texels_a_sample;
  HWY_ALIGN int16_t positions[16];
  for (int x = 0, column = 0; x < row.count; x += row.texels_a_sample, ++column) {
    const auto from = hn::Set(d, row.light[column]);
    const auto change = hn::Set(d, static_cast<int16_t>(row.light[column + 1] - row.light[column]));
    const int texels = row.texels_a_sample < row.count - x ? row.texels_a_sample : row.count - x;
    for (int i = 0; i < texels; i += lanes) {
      const auto fraction = hn::Add(Fractions(d, 16, step), hn::Set(d, static_cast<int16_t>(i * step)));
      const auto light = hn::Add(from, hn::MulFixedPoint15(change, fraction));
      const auto colours = hn::PromoteTo(d, hn::LoadU(d8, row.texels + x + i));
      hn::Store(hn::Add(hn::AndNot(hn::Set(d, 255), light), colours), d, positions);
      const int last = texels - i < lanes ? texels - i : lanes;
      for (int lane = 0; lane < last; ++lane) row.out[x + i + lane] = row.colormap[positions[lane]];
    }
  }
}

// Two texels (eight 16-bit channels) a 128-bit block; wider vectors hold more texels.
void BuildRgbRow(const RgbRow& row) {
  const hn::CappedTag<int16_t, 8> d;
  const hn::Rebind<uint8_t, decltype(d)> d8;
  const int step = 32768 / row.texels_a_sample;
  const auto opaque = hn::Set(d, 255);
  HWY_ALIGN const int16_t kSecond[8] = {0, 0, 0, 0, 1, 1, 1, 1};
  const auto second = hn::Load(d, kSecond);
  HWY_ALIGN uint8_t pair[8];
  for (int x = 0; x < row.count; x += 2) {
    const int16_t* sample = row.light + x / row.texels_a_sample * 4;
    const hn::CappedTag<int16_t, 4> half;
    const auto from = hn::Combine(d, hn::LoadU(half, sample), hn::LoadU(half, sample));
    const auto to = hn::Combine(d, hn::LoadU(half, sample + 4), hn::LoadU(half, sample + 4));
    const auto fraction = hn::Mul(hn::Add(hn::Set(d, static_cast<int16_t>(x % row.texels_a_sample)), second),
                                  hn::Set(d, static_cast<int16_t>(step)));
    const auto light = hn::Add(from, hn::MulFixedPoint15(hn::Sub(to, from), fraction));
    const auto colours = hn::PromoteTo(d, hn::LoadU(d8, reinterpret_cast<const uint8_t*>(row.texels + x)));
    const auto lit = hn::Min(hn::MulFixedPoint15(hn::Add(colours, colours), light), opaque);
    hn::Store(hn::DemoteTo(d8, lit), d8, pair);
    for (int i = 0; i < 2 && x + i < row.count; ++i) {
      const uint32_t texel = row.texels[x + i];
      uint32_t shaded;
      __builtin_memcpy(&shaded, pair + 4 * i, 4);
      row.out[x + i] = (texel >> 24 == 0 ? texel : shaded) | 0xff000000u;
    }
  }
}

#endif

}  // namespace temblor::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace temblor::render {

HWY_EXPORT(BuildIndexedRow);
HWY_EXPORT(BuildRgbRow);

void build_indexed_row_vector(const IndexedRow& row) {
  HWY_DYNAMIC_DISPATCH(BuildIndexedRow)(row);
}
void build_rgb_row_vector(const RgbRow& row) {
  HWY_DYNAMIC_DISPATCH(BuildRgbRow)(row);
}

}  // namespace temblor::render
#endif
