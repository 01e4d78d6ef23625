// Hot loop. The SIMD versions of fog_kernels_scalar.cpp, compiled once for each instruction set.
#include "render/color/fog_kernels.h"

// Processors with lookups in tables of 128 bytes (AVX-512 VBMI) deserve a target of their own here.
#define HWY_WANT_AVX3_DL 1

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/color/fog_kernels_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace temblor::render::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET == HWY_AVX3_DL

// The depths of 64 pixels. Pixels beyond the end of the row are excluded from every mask.
struct Depths {
  __m512 quarter[4];

  HWY_INLINE Depths(const float* depths, __mmask64 inside) {
    for (int i = 0; i < 4; ++i)
      quarter[i] = _mm512_maskz_loadu_ps(static_cast<__mmask16>(inside >> (16 * i)), depths + 16 * i);
  }
  template <int kPredicate>
  HWY_INLINE __mmask64 Compare(float bound) const {
    const __m512 bounds = _mm512_set1_ps(bound);
    return Joined(_mm512_cmp_ps_mask(quarter[0], bounds, kPredicate),
                  _mm512_cmp_ps_mask(quarter[1], bounds, kPredicate),
                  _mm512_cmp_ps_mask(quarter[2], bounds, kPredicate),
                  _mm512_cmp_ps_mask(quarter[3], bounds, kPredicate));
  }
  HWY_INLINE __mmask64 Within(float end, float next_end) const {
    return Compare<_CMP_LT_OQ>(end) & Compare<_CMP_NLT_UQ>(next_end);
  }
  // The pixels whose depth is exactly sky + i * step; pixel 0 is number `first` of the row.
  HWY_INLINE __mmask64 OnPlane(float sky, float step, int first) const {
    __mmask16 equal[4];
    for (int i = 0; i < 4; ++i) {
      const __m512i number =
          _mm512_add_epi32(_mm512_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15),
                           _mm512_set1_epi32(first + 16 * i));
      const __m512 plane =
          _mm512_add_ps(_mm512_set1_ps(sky), _mm512_mul_ps(_mm512_cvtepi32_ps(number), _mm512_set1_ps(step)));
      equal[i] = _mm512_cmp_ps_mask(quarter[i], plane, _CMP_EQ_OQ);
    }
    return Joined(equal[0], equal[1], equal[2], equal[3]);
  }
  // The largest depth among the pixels in the mask.
  HWY_INLINE float Nearest(__mmask64 among) const {
    const __m512 none = _mm512_set1_ps(-__builtin_inff());
    __m512 most = none;
    for (int i = 0; i < 4; ++i)
      most = _mm512_max_ps(most,
                           _mm512_mask_blend_ps(static_cast<__mmask16>(among >> (16 * i)), none, quarter[i]));
    return _mm512_reduce_max_ps(most);
  }

 private:
  static HWY_INLINE __mmask64 Joined(__mmask16 a, __mmask16 b, __mmask16 c, __mmask16 d) {
    return _mm512_kunpackd(_mm512_kunpackw(d, c), _mm512_kunpackw(b, a));
  }
};

// Looks 64 indices up in a table of 256 bytes, as two tables of 128.
HWY_INLINE __m512i LookUp(const uint8_t* table, __m512i indices) {
  const __m512i lower =
      _mm512_permutex2var_epi8(_mm512_loadu_si512(table), indices, _mm512_loadu_si512(table + 64));
  const __m512i upper =
      _mm512_permutex2var_epi8(_mm512_loadu_si512(table + 128), indices, _mm512_loadu_si512(table + 192));
  return _mm512_mask_blend_epi8(_mm512_movepi8_mask(indices), lower, upper);
}

// 64 pixels at a time. They usually share one step of fog, that of the previous pixels. If not, one lookup is
// made for each step that occurs among them.
void FogRowU8(const FogRow& row) {
  auto* const pixels = static_cast<uint8_t*>(row.pixels);
  const float* const ends = row.step_end_depths;
  int step = 0;
  for (int first = 0; first < row.count; first += 64) {
    const int left = row.count - first;
    const __mmask64 inside = left >= 64 ? ~__mmask64{0} : (__mmask64{1} << left) - 1;
    const Depths depths(row.depth + first, inside);
    const __m512i under = _mm512_maskz_loadu_epi8(inside, pixels + first);
    __mmask64 remaining = inside;
    __m512i fogged = under;
    if (row.has_sky) {
      const __mmask64 sky = depths.OnPlane(row.sky, row.sky_step, first);
      fogged = LookUp(row.rows + row.sky_share * kFogSteps / 256 * 256, under);
      remaining &= ~sky;
    }
    __mmask64 in_step = remaining & depths.Within(ends[step], ends[step + 1]);
    for (;;) {
      fogged = _mm512_mask_mov_epi8(fogged, in_step, LookUp(row.rows + step * 256, under));
      remaining &= ~in_step;
      if (remaining == 0) break;
      // The next step is usually a neighbor of this one.
      const bool is_farther = (remaining & depths.Compare<_CMP_LT_OQ>(ends[step + 1])) != 0;
      step = is_farther ? step + 1 : HWY_MAX(step - 1, 0);
      in_step = remaining & depths.Within(ends[step], ends[step + 1]);
      if (in_step != 0) continue;
      step = fog_step_at(ends, depths.Nearest(remaining));
      in_step = remaining & depths.Compare<_CMP_NLT_UQ>(ends[step + 1]);
    }
    _mm512_mask_storeu_epi8(pixels + first, inside, fogged);
  }
}

#elif HWY_TARGET == HWY_SCALAR

void FogRowU8(const FogRow& row) {
  fog_row_u8_scalar(row);
}

#else

using D8 = hn::CappedTag<uint8_t, 32>;
using DS8 = hn::RebindToSigned<D8>;
using DDepth = hn::RepartitionToWide<hn::RepartitionToWide<D8> >;
using DDepthF = hn::RebindToFloat<DDepth>;
constexpr int kGroup = static_cast<int>(hn::MaxLanes(D8()));

// Whether a group of pixels lies within one step.
HWY_INLINE bool IsWithin(const float* depths, float end, float next_end) {
  const DDepthF d;
  const auto nearer = hn::Set(d, end), farther = hn::Set(d, next_end);
  auto within = hn::And(hn::Lt(hn::LoadU(d, depths), nearer), hn::Ge(hn::LoadU(d, depths), farther));
  for (int i = static_cast<int>(hn::Lanes(d)); i < kGroup; i += static_cast<int>(hn::Lanes(d))) {
    const auto depth = hn::LoadU(d, depths + i);
    within = hn::And(within, hn::And(hn::Lt(depth, nearer), hn::Ge(depth, farther)));
  }
  return hn::AllTrue(d, within);
}

// The same for the plane of the sky; `first` is the number of the group's first pixel.
HWY_INLINE bool IsSky(const FogRow& row, int first) {
  const DDepthF d;
  auto is_sky = hn::MaskFromVec(hn::BitCast(d, hn::Set(DDepth(), ~0u)));
  for (int i = 0; i < kGroup; i += static_cast<int>(hn::Lanes(d))) {
    const auto number = hn::ConvertTo(d, hn::Iota(hn::RebindToSigned<DDepth>(), first + i));
    const auto sky = hn::Add(hn::Set(d, row.sky), hn::Mul(number, hn::Set(d, row.sky_step)));
    is_sky = hn::And(is_sky, hn::Eq(hn::LoadU(d, row.depth + first + i), sky));
  }
  return hn::AllTrue(d, is_sky);
}

// A lookup in a table of 16 << kBits bytes. One in 16 bytes takes the lowest four bits of an index; then each
// higher bit chooses one of two results. In `top_bits[n]`, bit 4 + n of the index is the top one.
template <int kBits>
HWY_INLINE hn::Vec<D8> LookUp(const uint8_t* table, hn::Vec<D8> low_bits, const hn::Vec<DS8> (&top_bits)[4]) {
  const D8 d;
  if constexpr (kBits == 0) {
    return hn::TableLookupBytes(hn::LoadDup128(d, table), low_bits);
  } else {
    const auto lower = hn::BitCast(DS8(), LookUp<kBits - 1>(table, low_bits, top_bits));
    const auto upper = hn::BitCast(DS8(), LookUp<kBits - 1>(table + (8 << kBits), low_bits, top_bits));
    return hn::BitCast(d, hn::IfNegativeThenElse(top_bits[kBits - 1], upper, lower));
  }
}

// Looks a group up in a table of 256 bytes.
HWY_INLINE void LookUp(const uint8_t* table, uint8_t* io_indices) {
  const D8 d;
  const auto indices = hn::LoadU(d, io_indices);
  const hn::Vec<DS8> top_bits[4] = {
      hn::BitCast(DS8(), hn::ShiftLeft<3>(indices)), hn::BitCast(DS8(), hn::ShiftLeft<2>(indices)),
      hn::BitCast(DS8(), hn::ShiftLeft<1>(indices)), hn::BitCast(DS8(), indices)};
  hn::StoreU(LookUp<4>(table, hn::And(indices, hn::Set(d, 15)), top_bits), d, io_indices);
}

// Fogs up to kGroup pixels that are not sky, one by one, and returns the step of the last one. Their cells
// (see FogCells) are found first, for all of them.
HWY_INLINE int FogSinglePixels(const FogRow& row, int first, int end, int step) {
  HWY_ALIGN int32_t cells[kGroup];
  const hn::RebindToSigned<DDepth> d;
  const auto lowest = hn::Set(d, row.cells->first), last = hn::Set(d, row.cells->count - 1);
  const float* const depths = row.depth + first;
  const int count = end - first;
  int found = 0;
  for (; found + static_cast<int>(hn::Lanes(d)) <= count; found += static_cast<int>(hn::Lanes(d))) {
    const auto number =
        hn::ShiftRight<FogCells::kShift>(hn::BitCast(d, hn::LoadU(DDepthF(), depths + found)));
    hn::Store(hn::Max(hn::Min(hn::Sub(number, lowest), last), hn::Zero(d)), d, cells + found);
  }
  for (; found < count; ++found) cells[found] = find_fog_cell(*row.cells, depths[found]);
  const float* const ends = row.cells->ends;
  const int32_t* const steps = row.cells->steps;
  const uint8_t* const rows = row.rows;
  auto* const pixels = static_cast<uint8_t*>(row.pixels) + first;
  for (int i = 0; i < count; ++i) {
    step = steps[cells[i]] + (depths[i] < ends[cells[i]] ? 1 : 0);
    pixels[i] = rows[step * 256 + pixels[i]];
  }
  return step;
}

// A group of pixels at a time: most groups lie within one step, that of the previous pixels, or are all sky.
void FogRowU8(const FogRow& row) {
  if (row.cells == nullptr) return fog_row_u8_scalar(row);
  auto* const pixels = static_cast<uint8_t*>(row.pixels);
  const uint8_t* const sky = row.rows + row.sky_share * kFogSteps / 256 * 256;
  int step = 0;
  for (int first = 0; first < row.count; first += kGroup) {
    const int end = HWY_MIN(first + kGroup, row.count);
    const bool is_whole = end == first + kGroup;
    if (row.has_sky && is_whole && IsSky(row, first)) {
      LookUp(sky, pixels + first);
    } else if (row.has_sky) {
      fog_pixels_u8_scalar(row, first, end);
    } else if (is_whole &&
               IsWithin(row.depth + first, row.step_end_depths[step], row.step_end_depths[step + 1])) {
      LookUp(row.rows + step * 256, pixels + first);
    } else {
      step = FogSinglePixels(row, first, end, step);
    }
  }
}

#endif

#if HWY_TARGET == HWY_SCALAR

void FogRowU32(const FogRow& row) {
  fog_row_u32_scalar(row);
}

#else

using DF = hn::CappedTag<float, 16>;
using DI = hn::Rebind<int32_t, DF>;
using DU = hn::RebindToUnsigned<DI>;
using D16 = hn::Repartition<uint16_t, DU>;

// table[pieces], for a table of 16 entries.
HWY_INLINE hn::Vec<DF> PieceOf(const float* table, hn::Vec<DI> pieces) {
  const DF d;
#if HWY_TARGET <= HWY_AVX3
  return hn::TableLookupLanes(hn::LoadU(d, table), hn::IndicesFromVec(d, pieces));
#elif HWY_TARGET <= HWY_AVX2
  const auto indices = hn::IndicesFromVec(d, hn::And(pieces, hn::Set(DI(), 7)));
  const auto low = hn::TableLookupLanes(hn::LoadU(d, table), indices);
  const auto high = hn::TableLookupLanes(hn::LoadU(d, table + 8), indices);
  return hn::IfThenElse(hn::RebindMask(d, hn::Gt(pieces, hn::Set(DI(), 7))), high, low);
#else
  return hn::GatherIndex(d, table, pieces);
#endif
}

// The curve at x. Neighboring pixels nearly always use the same polynomial, whose coefficients are then the
// same in all lanes.
HWY_INLINE hn::Vec<DF> CurveAt(const FogCurve& curve, hn::Vec<DF> x) {
  const DF d;
  const DI di;
  const auto pieces = hn::And(hn::ShiftRight<22>(hn::BitCast(di, x)), hn::Set(di, kFogPieces - 1));
  const int piece = hn::GetLane(pieces);
  if (HWY_LIKELY(hn::AllTrue(di, hn::Eq(pieces, hn::Set(di, piece))))) {
    auto share = hn::Set(d, curve.cubic[3][piece]);
    for (int power = 2; power >= 0; --power)
      share = hn::Add(hn::Mul(share, x), hn::Set(d, curve.cubic[power][piece]));
    return share;
  }
  auto share = PieceOf(curve.cubic[3], pieces);
  for (int power = 2; power >= 0; --power)
    share = hn::Add(hn::Mul(share, x), PieceOf(curve.cubic[power], pieces));
  return share;
}

// Shares are never negative and fit 32 bits; Highway's ConvertTo also guards against numbers that do not.
HWY_INLINE hn::Vec<DI> Truncate(hn::Vec<DF> v) {
#if HWY_TARGET == HWY_AVX2
  return hn::Vec<DI>{_mm256_cvttps_epi32(v.raw)};
#else
  return hn::ConvertTo(DI(), v);
#endif
}

// The values that all pixels of a row share. They are read once: the compiler cannot know that no pixel
// overlaps `row`.
struct FogOfRow {
  hn::Vec<DF> rate, sky, sky_step;
  hn::Vec<DI> sky_share;
  hn::Vec<D16> low_color, high_color;
  const FogCurve& curve;

  HWY_INLINE explicit FogOfRow(const FogRow& row)
      : rate(hn::Set(DF(), row.inverse_rate)),
        sky(hn::Set(DF(), row.sky)),
        sky_step(hn::Set(DF(), row.sky_step)),
        sky_share(hn::Set(DI(), row.sky_share)),
        low_color(hn::BitCast(D16(), hn::Set(DU(), row.color & 0x00ff00ffu))),
        high_color(hn::BitCast(D16(), hn::Set(DU(), row.color >> 8 & 0x00ff00ffu))),
        curve(*row.curve) {}
};

// The share of fog in 256ths, for the pixels from number i of the row on.
template <bool kPerspective, bool kHasSky>
HWY_INLINE hn::Vec<DI> Share256(const FogOfRow& fog, int i, const float* depths) {
  const DF d;
  const DI di;
  const auto depth = hn::LoadU(d, depths);
  auto x = kPerspective ? hn::Mul(depth, fog.rate)
                        : hn::Div(fog.rate, hn::Max(hn::Neg(depth), hn::Set(d, kMinDistance)));
  x = hn::Max(hn::Min(x, hn::Set(d, kMaxNearness)), hn::Set(d, kMinNearness));
  const auto whole = Truncate(CurveAt(fog.curve, x));
  if (!kHasSky) return whole;
  const auto lane = hn::Iota(d, static_cast<float>(i));
  const auto sky = hn::Add(fog.sky, hn::Mul(lane, fog.sky_step));
  return hn::IfThenElse(hn::RebindMask(di, hn::Eq(depth, sky)), fog.sky_share, whole);
}

// Fogs one vector of pixels. Two channels at a time, in the halves of a lane: under * 256 + (color - under) *
// fog, a sum that is right modulo 2^16 although its parts wrap. Alpha gets no fog.
template <bool kPerspective, bool kHasSky>
HWY_INLINE void FogPixels(const FogOfRow& row, int i, const float* depths, uint32_t* pixels) {
  const DU du;
  const D16 d16;
  const auto round = hn::Set(d16, 128);
  const auto fog = hn::BitCast(du, Share256<kPerspective, kHasSky>(row, i, depths));
  const auto low_fog = hn::BitCast(d16, hn::Or(fog, hn::ShiftLeft<16>(fog)));
  const auto high_fog = hn::BitCast(d16, fog);
  const auto under = hn::BitCast(d16, hn::LoadU(du, pixels));
  const auto low_bytes = hn::Set(d16, 0x00ff), high_bytes = hn::Set(d16, 0xff00);
  const auto low = hn::Mul(hn::Sub(row.low_color, hn::And(under, low_bytes)), low_fog);
  const auto high = hn::Mul(hn::Sub(row.high_color, hn::ShiftRight<8>(under)), high_fog);
  const auto low_sum = hn::Add(hn::Add(hn::ShiftLeft<8>(under), round), low);
  const auto high_sum = hn::Add(hn::Add(hn::And(under, high_bytes), round), high);
  const auto out = hn::Or(hn::ShiftRight<8>(low_sum), hn::And(high_sum, high_bytes));
  hn::StoreU(hn::BitCast(du, out), du, pixels);
}

template <bool kPerspective, bool kHasSky>
HWY_INLINE void FogWholeRow(const FogRow& row) {
  constexpr int kLanes = static_cast<int>(hn::MaxLanes(DI()));
  const FogOfRow fog(row);
  const int count = row.count;
  const float* const depths = row.depth;
  auto* const pixels = static_cast<uint32_t*>(row.pixels);
  int i = 0;
  for (; i + kLanes <= count; i += kLanes) FogPixels<kPerspective, kHasSky>(fog, i, depths + i, pixels + i);
  if (i == count) return;
  // The last pixels are copied to a buffer: memory after the row may be unreadable or another thread's.
  HWY_ALIGN float last_depths[16] = {};
  HWY_ALIGN uint32_t last[16] = {};
  for (int j = i; j < count; ++j) {
    last_depths[j - i] = depths[j];
    last[j - i] = pixels[j];
  }
  FogPixels<kPerspective, kHasSky>(fog, i, last_depths, last);
  for (int j = i; j < count; ++j) pixels[j] = last[j - i];
}

void FogRowU32(const FogRow& row) {
  if (!row.perspective)
    row.has_sky ? FogWholeRow<false, true>(row) : FogWholeRow<false, false>(row);
  else
    row.has_sky ? FogWholeRow<true, true>(row) : FogWholeRow<true, false>(row);
}

#endif

}  // namespace temblor::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace temblor::render {

HWY_EXPORT(FogRowU8);
HWY_EXPORT(FogRowU32);

void fog_row_u8_simd(const FogRow& row) {
  HWY_DYNAMIC_DISPATCH(FogRowU8)(row);
}
void fog_row_u32_simd(const FogRow& row) {
  HWY_DYNAMIC_DISPATCH(FogRowU32)(row);
}

}  // namespace temblor::render
#endif
