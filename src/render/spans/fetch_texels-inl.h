// The parts that the SIMD kernels of spans share, compiled once for each instruction set: include it after
// hwy/foreach_target.h. It fetches the texels of a vector of pixels in one of two ways:
//   window    if the texels lie within a few rows of a vector's width, those rows are loaded and the pixels
//             picked out of registers (FetchWindow)
//   gather    otherwise (FetchScattered)
// AVX-512 and AVX2 have their own instructions for several steps; the generic code is for the other targets.
#if defined(TEMBLOR_RENDER_SPANS_FETCH_TEXELS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TEMBLOR_RENDER_SPANS_FETCH_TEXELS_INL_H
#undef TEMBLOR_RENDER_SPANS_FETCH_TEXELS_INL_H
#else
#define TEMBLOR_RENDER_SPANS_FETCH_TEXELS_INL_H
#endif

#include <hwy/highway.h>

#include <cstring>

#include "render/spans/span_kernels.h"

HWY_BEFORE_NAMESPACE();
namespace temblor::render::HWY_NAMESPACE {

#if HWY_TARGET != HWY_SCALAR

namespace hn = hwy::HWY_NAMESPACE;

using DF = hn::CappedTag<float, 16>;
using DI = hn::Rebind<int32_t, DF>;
using DU = hn::RebindToUnsigned<DI>;
using D8 = hn::Rebind<uint8_t, DU>;
using VF = hn::Vec<DF>;
using VI = hn::Vec<DI>;

constexpr int kMaxLanes = 16;

HWY_INLINE float At(const KernelPlane& plane, const Span& span) {
  return static_cast<float>(plane.at_origin + plane.dx * span.x + plane.dy * span.y);
}

// Stores the first `count` lanes only: later pixels may belong to another thread.
template <class D>
HWY_INLINE void StoreFirst(D d, hn::Vec<D> v, hn::TFromD<D>* out, int count) {
#if HWY_TARGET <= HWY_AVX3
  hn::BlendedStore(v, hn::FirstN(d, static_cast<size_t>(count)), d, out);
#elif HWY_TARGET == HWY_AVX2
  if constexpr (sizeof(hn::TFromD<D>) == 4) {  // one masked store
    hn::BlendedStore(v, hn::FirstN(d, static_cast<size_t>(count)), d, out);
  } else {  // 4, 2, and 1 of the eight bytes
    auto bytes = static_cast<uint64_t>(_mm_cvtsi128_si64(v.raw));
    for (int part = 4; part > 0; part /= 2) {
      if ((count & part) == 0) continue;
      std::memcpy(out, &bytes, static_cast<size_t>(part));
      bytes >>= 8 * part;
      out += part;
    }
  }
#else
  HWY_ALIGN hn::TFromD<D> lanes[kMaxLanes];
  hn::Store(v, d, lanes);
  for (int i = 0; i < count; ++i) out[i] = lanes[i];
#endif
}

// Converts to integers by adding a large float, which leaves the whole number in the low bits. Highway's
// ConvertTo guards against numbers that do not fit 32 bits, which these never are. The constant part of the
// sum is kShiftBits; it cancels where two results are subtracted.
constexpr float kShift = 12582912.0f;  // 1.5 * 2^23: for numbers from -2^22 to 2^22
constexpr int kShiftBits = 0x4b400000;
HWY_INLINE VI FloorBiased(VF v) {
#if HWY_TARGET <= HWY_AVX3  // an addition that rounds down does both at once
  return VI{_mm512_castps_si512(
      _mm512_add_round_ps(v.raw, _mm512_set1_ps(kShift), _MM_FROUND_TO_NEG_INF | _MM_FROUND_NO_EXC))};
#else
  return hn::BitCast(DI(), hn::Add(hn::Floor(v), hn::Set(DF(), kShift)));
#endif
}

// The same for numbers that are not negative, plus kBias.
#if HWY_TARGET == HWY_AVX2
constexpr int kBias = 0;
HWY_INLINE VI TruncateBiased(VF v) {
  return VI{_mm256_cvttps_epi32(v.raw)};
}
#else
constexpr int kBias = kShiftBits;
HWY_INLINE VI TruncateBiased(VF v) {
  return FloorBiased(v);
}
#endif

// The column and row of each pixel's texel, plus kBias.
struct TexelLanes {
  VI column, row;
};

// The layout of a texture in memory.
struct Rows {
  int texels_per_row, last_row;
};

// The direction in which a span crosses the texture.
struct Direction {
  bool left, up;
};

HWY_INLINE hn::Vec<DU> LoadTexels(const uint32_t* texels) {
  return hn::LoadU(DU(), texels);
}
HWY_INLINE hn::Vec<DU> LoadTexels(const uint8_t* texels) {
  return hn::PromoteTo(DU(), hn::LoadU(D8(), texels));
}
HWY_INLINE void StoreTexels(hn::Vec<DU> texels, uint32_t* out, int count) {
  if (count == static_cast<int>(hn::Lanes(DU())))
    hn::StoreU(texels, DU(), out);
  else
    StoreFirst(DU(), texels, out, count);
}
HWY_INLINE void StoreTexels(hn::Vec<DU> texels, uint8_t* out, int count) {
#if HWY_TARGET <= HWY_AVX3
  const hn::Vec<D8> bytes{
      _mm512_cvtepi32_epi8(texels.raw)};  // one instruction; TruncateTo takes two shuffles
#else
  const auto bytes = hn::TruncateTo(D8(), texels);
#endif
  if (count == static_cast<int>(hn::Lanes(DU())))
    hn::StoreU(bytes, D8(), out);
  else
    StoreFirst(D8(), bytes, out, count);
}

#if HWY_TARGET == HWY_AVX2

// The texels of eight pixels from rows that begin at the same column. Only the lowest bits of `row` count.
template <int kRows>
HWY_INLINE void PickTexels(const uint32_t* const (&rows)[kRows], VI column, VI row, uint32_t* out,
                           int count) {
  const auto pick = [&](int number) HWY_ATTR {
    const __m256i texels = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(rows[number]));
    return _mm256_castsi256_ps(_mm256_permutevar8x32_epi32(texels, column.raw));
  };
  // These blends look at the top bit of each lane.
  const __m256 is_odd = _mm256_castsi256_ps(_mm256_slli_epi32(row.raw, 31));
  __m256 texels = _mm256_blendv_ps(pick(0), pick(1), is_odd);
  if constexpr (kRows == 4) {
    const __m256 is_far = _mm256_castsi256_ps(_mm256_slli_epi32(row.raw, 30));
    texels = _mm256_blendv_ps(texels, _mm256_blendv_ps(pick(2), pick(3), is_odd), is_far);
  }
  StoreTexels(hn::Vec<DU>{_mm256_castps_si256(texels)}, out, count);
}

// Eight texels of each row, in one table.
HWY_INLINE __m128i LoadTable(const uint8_t* first_row, const uint8_t* second_row) {
  return _mm_unpacklo_epi64(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(first_row)),
                            _mm_loadl_epi64(reinterpret_cast<const __m128i*>(second_row)));
}

template <int kRows>
HWY_INLINE void PickTexels(const uint8_t* const (&rows)[kRows], VI column, VI row, uint8_t* out, int count) {
  const __m256i index = _mm256_or_si256(column.raw, _mm256_slli_epi32(row.raw, 3));
  const __m256i low_bytes = _mm256_shuffle_epi8(
      index, _mm256_broadcastsi128_si256(_mm_setr_epi32(0x0c080400, 0x0c080400, 0x0c080400, 0x0c080400)));
  const __m128i indices =
      _mm_unpacklo_epi32(_mm256_castsi256_si128(low_bytes), _mm256_extracti128_si256(low_bytes, 1));
  // A lookup ignores bits 4 to 6 of its indices, and the blend below takes bit 7, which was bit 4.
  __m128i texels = _mm_shuffle_epi8(LoadTable(rows[0], rows[1]), indices);
  if constexpr (kRows == 4) {
    const __m128i far = _mm_shuffle_epi8(LoadTable(rows[2], rows[3]), indices);
    texels = _mm_blendv_epi8(texels, far, _mm_slli_epi16(indices, 3));
  }
  if (count == static_cast<int>(hn::Lanes(DU())))
    _mm_storel_epi64(reinterpret_cast<__m128i*>(out), texels);
  else
    StoreFirst(D8(), hn::Vec<D8>{texels}, out, count);
}

#endif

// Lane i of the result is lane index[i] of `first` followed by `second`.
HWY_INLINE hn::Vec<DU> PickOfTwo(hn::Vec<DU> first, hn::Vec<DU> second, hn::Vec<DU> index) {
#if HWY_TARGET <= HWY_AVX3
  return hn::Vec<DU>{_mm512_permutex2var_epi32(first.raw, index.raw, second.raw)};
#else
  const DU du;
  const auto lanes = hn::Set(du, static_cast<uint32_t>(hn::Lanes(du)));
  const auto pick = hn::IndicesFromVec(du, hn::And(index, hn::Sub(lanes, hn::Set(du, 1))));
  const auto in_second = hn::Ne(hn::And(index, lanes), hn::Zero(du));
  return hn::IfThenElse(in_second, hn::TableLookupLanes(second, pick), hn::TableLookupLanes(first, pick));
#endif
}

// Close to the eye, a vector of pixels shows a few neighboring texels. Loads a window of kRows rows, each as
// wide as a vector, and picks the pixels out of registers:
//
//   texels + first_row * texels_per_row + first_column
//     row 0   [ 0  1  2 ...  lanes - 1 ]
//     row 1   [ 0  1  2 ...  lanes - 1 ]      index = column | row << log2(lanes)
//
// The window is placed so that the span leaves it as late as possible. Returns false, without drawing, if
// some texel does not lie in the window.
#if HWY_TARGET == HWY_AVX2
template <int kRows, typename Texel>
HWY_INLINE bool FetchWindow(const Texel* HWY_RESTRICT texels, const Rows& rows, Direction direction,
                            const TexelLanes& at, Texel* HWY_RESTRICT out, int count) {
  const DI di;
  constexpr int kLanes = static_cast<int>(hn::MaxLanes(DU()));
  // The first column and row of the window, in all lanes.
  const VI back_columns = hn::Set(di, direction.left ? kLanes - 1 : 0);
  const VI back_rows = hn::Set(di, direction.up ? kRows - 1 : 0);
  const VI pixel_column{_mm256_broadcastd_epi32(_mm256_castsi256_si128(at.column.raw))};
  const VI pixel_row{_mm256_broadcastd_epi32(_mm256_castsi256_si128(at.row.raw))};
  const VI first_column = hn::Max(hn::Sub(pixel_column, back_columns), hn::Zero(di));
  const VI first_row = hn::Max(hn::Sub(pixel_row, back_rows), hn::Zero(di));
  const VI column = hn::Sub(at.column, first_column), row = hn::Sub(at.row, first_row);
  // Both numbers fit if they have no other bits than 0 to kLanes - 1 and 0 to kRows - 1.
  VI used = hn::Or(column, hn::ShiftLeft<hwy::FloorLog2(static_cast<uint32_t>(kLanes / kRows))>(row));
  if (count < kLanes) used = hn::IfThenElseZero(hn::FirstN(di, static_cast<size_t>(count)), used);
  if (!_mm256_testz_si256(used.raw, _mm256_set1_epi32(~(kLanes - 1)))) return false;
  int below = rows.last_row - hn::GetLane(first_row);
  const Texel* window[kRows];
  window[0] = texels + hn::GetLane(first_row) * rows.texels_per_row + hn::GetLane(first_column);
  for (int i = 1; i < kRows; ++i) window[i] = window[i - 1] + (below-- > 0 ? rows.texels_per_row : 0);
  PickTexels<kRows>(window, column, row, out, count);
  return true;
}
#else
template <int kRows, typename Texel>
HWY_INLINE bool FetchWindow(const Texel* HWY_RESTRICT texels, const Rows& rows, Direction direction,
                            const TexelLanes& at, Texel* HWY_RESTRICT out, int count) {
  const DI di;
  const DU du;
  const int lanes = static_cast<int>(hn::Lanes(di));
  int first_column = hn::GetLane(at.column) - kBias, first_row = hn::GetLane(at.row) - kBias;
  const int back_columns = direction.left ? lanes - 1 : 0, back_rows = direction.up ? kRows - 1 : 0;
  first_column = first_column < back_columns ? 0 : first_column - back_columns;
  first_row = first_row < back_rows ? 0 : first_row - back_rows;
  const auto column = hn::BitCast(du, hn::Sub(at.column, hn::Set(di, first_column + kBias)));
  const auto row = hn::BitCast(du, hn::Sub(at.row, hn::Set(di, first_row + kBias)));
  constexpr int kLanes = static_cast<int>(hn::MaxLanes(DU()));
  // lanes and kRows are powers of two, so one comparison tests both column < lanes and row < kRows.
  constexpr int kRowShift = hwy::FloorLog2(static_cast<uint32_t>(kLanes / kRows));
  auto fits =
      hn::Lt(hn::Or(column, hn::ShiftLeft<kRowShift>(row)), hn::Set(du, static_cast<uint32_t>(lanes)));
  if (count < lanes) fits = hn::Or(fits, hn::Not(hn::FirstN(du, static_cast<size_t>(count))));
  if (!hn::AllTrue(du, fits)) return false;
  const Texel* window = texels + first_row * rows.texels_per_row + first_column;
  const Texel* next = window + (first_row < rows.last_row ? rows.texels_per_row : 0);
  const auto index = hn::Or(column, hn::ShiftLeft<hwy::FloorLog2(static_cast<uint32_t>(kLanes))>(row));
  auto colors = PickOfTwo(LoadTexels(window), LoadTexels(next), index);
  if constexpr (kRows == 4) {
    const Texel* third = next + (first_row + 1 < rows.last_row ? rows.texels_per_row : 0);
    const Texel* fourth = third + (first_row + 2 < rows.last_row ? rows.texels_per_row : 0);
    const auto far = PickOfTwo(LoadTexels(third), LoadTexels(fourth), index);
    colors = hn::IfThenElse(hn::Gt(row, hn::Set(du, 1u)), far, colors);
  }
  StoreTexels(colors, out, count);
  return true;
}
#endif

HWY_INLINE hn::Vec<DU> GatherTexels(const uint32_t* texels, VI numbers) {
  return hn::GatherIndex(DU(), texels, numbers);
}
// Gathers 32 bits per texel; the other three bytes are masked off.
HWY_INLINE hn::Vec<DU> GatherTexels(const uint8_t* texels, VI numbers) {
  return hn::And(hn::GatherOffset(DU(), reinterpret_cast<const uint32_t*>(texels), numbers),
                 hn::Set(DU(), 255));
}

template <typename Texel>
HWY_INLINE void FetchScattered(const Texel* HWY_RESTRICT texels, const Rows& rows, const TexelLanes& at,
                               Texel* HWY_RESTRICT out, int count) {
  const DI di;
  const VI bias = hn::Set(di, kBias);
  const VI before = hn::Mul(hn::Sub(at.row, bias), hn::Set(di, rows.texels_per_row));
  VI positions = hn::Add(before, hn::Sub(at.column, bias));
  if (count < static_cast<int>(hn::Lanes(di)))
    positions = hn::IfThenElseZero(hn::FirstN(di, static_cast<size_t>(count)), positions);
  StoreTexels(GatherTexels(texels, positions), out, count);
}

// kRows: the number of rows of texels that a vector of pixels probably needs; 0: more than a window holds.
template <int kRows, typename Texel>
HWY_INLINE void Fetch(const Texel* HWY_RESTRICT texels, const Rows& rows, Direction direction,
                      const TexelLanes& at, Texel* HWY_RESTRICT out, int count) {
  if constexpr (kRows > 0)
    if (HWY_LIKELY(FetchWindow<kRows>(texels, rows, direction, at, out, count))) return;
  FetchScattered(texels, rows, at, out, count);
}

// A linear function along a span.
struct Line {
  float base, step;
  HWY_INLINE VF Lanes(int first) const {
    const DF d;
    const VF lane = hn::Iota(d, static_cast<float>(first));
    return hn::Add(hn::Set(d, base), hn::Mul(lane, hn::Set(d, step)));
  }
};

HWY_INLINE void FillDepth(const Line& line, int count, float* out) {
  const DF d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  int i = 0;
  for (; i + lanes <= count; i += lanes) hn::StoreU(line.Lanes(i), d, out + i);
  if (i < count) StoreFirst(d, line.Lanes(i), out + i, count - i);
}

#endif

}  // namespace temblor::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
