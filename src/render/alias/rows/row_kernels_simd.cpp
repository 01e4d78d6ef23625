// Hot loop: draws a list of rows, compiled once for each instruction set. Triangles of many pixels are drawn
// row by row, and those of few pixels column by column, because most lanes of a row's vector would be empty:
//
//   DrawRow       lanes are the pixels of a row        depth test; scalar code then looks up the texels
//   FillColumns   lanes are rows, one pixel of each    scalar code then tests, looks up, and writes it
//
// Both have the results of affine_triangle.h, bit for bit.
#include "render/alias/rows/row_list.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/alias/rows/row_kernels_simd.cpp"
#include <hwy/cache_control.h>
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace temblor::render::HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR

// Without vectors, no rows are listed (triangle_kernels_simd.cpp).
void DrawRowsU8(const TriangleJob&, const RowList&, const TriangleTarget&) {}
void DrawRowsU32(const TriangleJob&, const RowList&, const TriangleTarget&) {}

#else

namespace hn = hwy::HWY_NAMESPACE;

// Rows of most triangles are shorter than eight pixels; wider vectors would be mostly empty.
using DF = hn::CappedTag<float, 8>;
using DI = hn::Rebind<int32_t, DF>;
using DU = hn::RebindToUnsigned<DI>;
using D8 = hn::Rebind<uint8_t, DU>;
using VF = hn::Vec<DF>;
using VI = hn::Vec<DI>;
using VU = hn::Vec<DU>;
using MF = hn::Mask<DF>;
// Vectors of rows, as in triangle_kernels_simd.cpp.
using DDF = hn::Rebind<float, hn::CappedTag<double, 8> >;
using DDI = hn::Rebind<int32_t, DDF>;

// The distance, in rows of the list, at which the destination is prefetched.
constexpr size_t kRowsAhead = 24;
constexpr float kMinDepth = 1e-20f;

// Segments of rows, at most a vector long, whose depth is written and whose texels are still to be looked up.
// The lookup is done for many segments together, pixel by pixel: a gather takes as long for unused lanes as
// for used ones, and most lanes would be unused.
class RowSegments {
 public:
  bool has_room() const { return size_ < kCapacity; }
  // Adds `count` pixels; the bits of `shown` say which of them passed the depth test.
  HWY_INLINE void Add(int place, int count, uint8_t shown, VI texels, VI light) {
    place_[size_] = place;
    shown_[size_] = shown;
    first_[size_++] = static_cast<int32_t>(pixels_);
    hn::StoreU(texels, DI(), texels_ + pixels_);
    hn::StoreU(light, DI(), light_ + pixels_);
    pixels_ += static_cast<size_t>(count);
  }
  HWY_INLINE void Draw(const TriangleJob& job, uint8_t* out);
  HWY_INLINE void Draw(const TriangleJob& job, uint32_t* out);

 private:
  template <typename Pixel>
  HWY_INLINE void Store(const Pixel* colors, Pixel* out);

  static constexpr size_t kCapacity = 256, kMaxPixels = kCapacity * 8,
                          kSpare = 8;  // whole vectors are written
  int32_t place_[kCapacity], first_[kCapacity];
  uint8_t shown_[kCapacity];
  // By pixel.
  HWY_ALIGN int32_t texels_[kMaxPixels + kSpare], light_[kMaxPixels + kSpare];
  size_t size_ = 0, pixels_ = 0;
};

// Truncates. Highway's ConvertTo guards against numbers that do not fit 32 bits, which these never are.
template <typename D>
HWY_INLINE hn::Vec<hn::RebindToSigned<D> > ToWhole(D, hn::Vec<D> v) {
#if HWY_TARGET <= HWY_AVX2
  using Whole = hn::Vec<hn::RebindToSigned<D> >;
  if constexpr (hn::MaxLanes(D()) == 8)
    return Whole{_mm256_cvttps_epi32(v.raw)};
  else
    return Whole{_mm_cvttps_epi32(v.raw)};
#else
  return hn::ConvertTo(hn::RebindToSigned<D>(), v);
#endif
}

// The position of each lane's texel in the skin.
template <typename D>
HWY_INLINE hn::Vec<hn::RebindToSigned<D> > SkinTexels(D d, const TriangleJob& job, hn::Vec<D> s,
                                                      hn::Vec<D> t) {
  const auto last_s = hn::Set(d, static_cast<float>(job.skin_width - 1));
  const auto last_t = hn::Set(d, static_cast<float>(job.skin_height - 1));
  const auto column = ToWhole(d, hn::Max(hn::Min(s, last_s), hn::Zero(d)));
  const auto row = ToWhole(d, hn::Max(hn::Min(t, last_t), hn::Zero(d)));
  return hn::Add(hn::Mul(row, hn::Set(hn::RebindToSigned<D>(), job.skin_width)), column);
}

template <typename D>
HWY_INLINE hn::Vec<hn::RebindToSigned<D> > BoundedLight(D d, hn::Vec<D> light, uint8_t) {
  const auto whole = ToWhole(d, hn::Max(hn::Min(light, hn::Set(d, kDarkestRow)), hn::Zero(d)));
  return hn::And(whole, hn::Set(hn::RebindToSigned<D>(), ~255));
}
template <typename D>
HWY_INLINE hn::Vec<hn::RebindToSigned<D> > BoundedLight(D d, hn::Vec<D> light, uint32_t) {
  return ToWhole(d, hn::Max(hn::Min(light, hn::Set(d, kBrightestLight)), hn::Zero(d)));
}

// The SIMD version of lit_texel in affine_triangle.h.
HWY_INLINE VU LitColors(const TriangleJob& job, VU color, VI light) {
  const DU du;
  const DI di;
  const VU opaque = hn::Set(du, 0xff000000u);
  const auto channel = [&](VU value, int tint) HWY_ATTR {
    const VI tinted = hn::ShiftRight<15>(hn::Mul(light, hn::Set(di, tint)));
    const VI doubled = hn::BitCast(di, hn::Add(value, value));
    const VI lit = hn::ShiftRight<15>(hn::Add(hn::Mul(doubled, tinted), hn::Set(di, 16384)));
    return hn::BitCast(du, hn::Min(lit, hn::Set(di, 255)));
  };
  const VU byte = hn::Set(du, 255);
  const VU red = channel(hn::And(hn::ShiftRight<16>(color), byte), job.tint[0]);
  const VU green = channel(hn::And(hn::ShiftRight<8>(color), byte), job.tint[1]);
  const VU blue = channel(hn::And(color, byte), job.tint[2]);
  const VU lit = hn::Or(hn::Or(hn::ShiftLeft<16>(red), hn::ShiftLeft<8>(green)), blue);
  const auto is_lit = hn::Ne(hn::And(color, opaque), hn::Zero(du));
  return hn::Or(opaque, hn::IfThenElse(is_lit, lit, color));
}

// Pixels outside the mask may belong to another band: not even their old value may be written back.
#if HWY_TARGET <= HWY_AVX3
HWY_INLINE VF LoadDepth(MF covered, const float* depth, int) {
  return hn::MaskedLoad(covered, DF(), depth);
}
HWY_INLINE uint8_t StoreDepth(MF shown, VF depth, float* out) {
  hn::BlendedStore(depth, shown, DF(), out);
  return shown.raw;
}
HWY_INLINE void StorePixels(unsigned shown, const uint8_t* from, uint8_t* out) {
  hn::BlendedStore(hn::LoadU(D8(), from), hn::Mask<D8>{static_cast<__mmask16>(shown)}, D8(), out);
}
HWY_INLINE void StorePixels(unsigned shown, const uint32_t* from, uint32_t* out) {
  hn::BlendedStore(hn::LoadU(DU(), from), hn::Mask<DU>{static_cast<__mmask8>(shown)}, DU(), out);
}
#elif HWY_TARGET == HWY_AVX2
HWY_INLINE VF LoadDepth(MF covered, const float* depth, int) {
  return hn::MaskedLoad(covered, DF(), depth);
}
HWY_INLINE uint8_t StoreDepth(MF shown, VF depth, float* out) {
  hn::BlendedStore(depth, shown, DF(), out);
  return static_cast<uint8_t>(_mm256_movemask_ps(shown.raw));
}
HWY_INLINE void StorePixels(unsigned shown, const uint8_t* from, uint8_t* out) {
  if (shown == 255) return hn::StoreU(hn::LoadU(D8(), from), D8(), out);
  for (; shown != 0; shown &= shown - 1) {
    const size_t i = hwy::Num0BitsBelowLS1Bit_Nonzero32(shown);
    out[i] = from[i];
  }
}
HWY_INLINE void StorePixels(unsigned shown, const uint32_t* from, uint32_t* out) {
  const DU d;
  if (shown == 255) return hn::StoreU(hn::LoadU(d, from), d, out);
  const VU bit = hn::Shl(hn::Set(d, 1u), hn::Iota(d, 0u));
  hn::BlendedStore(hn::LoadU(d, from), hn::TestBit(hn::Set(d, shown), bit), d, out);
}
#else
HWY_INLINE VF LoadDepth(MF, const float* depth, int count) {
  HWY_ALIGN float lanes[8] = {};
  for (int i = 0; i < count; ++i) lanes[i] = depth[i];
  return hn::Load(DF(), lanes);
}
template <typename Pixel>
HWY_INLINE void StorePixels(unsigned shown, const Pixel* from, Pixel* out) {
  for (int i = 0; shown >> i != 0; ++i)
    if ((shown >> i & 1) != 0) out[i] = from[i];
}
HWY_INLINE uint8_t StoreDepth(MF shown, VF depth, float* out) {
  HWY_ALIGN float depths[8];
  hn::Store(depth, DF(), depths);
  uint8_t bits[8] = {};
  hn::StoreMaskBits(DF(), shown, bits);
  StorePixels(bits[0], depths, out);
  return bits[0];
}
#endif

template <typename Pixel>
HWY_INLINE void RowSegments::Store(const Pixel* colors, Pixel* out) {
  for (size_t i = 0; i < size_; ++i) StorePixels(shown_[i], colors + first_[i], out + place_[i]);
  size_ = pixels_ = 0;
}

HWY_INLINE void RowSegments::Draw(const TriangleJob& job, uint8_t* out) {
  HWY_ALIGN uint8_t colors[kMaxPixels + kSpare];
  look_up_texels_u8(job, texels_, light_, pixels_, colors);
  Store(colors, out);
}

HWY_INLINE void RowSegments::Draw(const TriangleJob& job, uint32_t* out) {
  const DU d;
  HWY_ALIGN uint32_t colors[kMaxPixels + kSpare];
  look_up_texels_u32(job, texels_, pixels_, colors);
  for (size_t i = 0; i < pixels_; i += hn::Lanes(d))
    hn::Store(LitColors(job, hn::Load(d, colors + i), hn::Load(DI(), light_ + i)), d, colors + i);
  Store(colors, out);
}

template <typename Pixel, bool kPerspective>
HWY_INLINE void DrawRow(const TriangleJob& job, const RowList& rows, size_t row, const TriangleTarget& target,
                        RowSegments& io_segments) {
  const DF d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const int end = rows.count[row];
  int x = 0;
  do {
    const int count = HWY_MIN(end - x, lanes), place = rows.place[row] + x;
    const VF lane = hn::Add(hn::Iota(d, 0.0f), hn::Set(d, static_cast<float>(x)));
    const auto at_lanes = [&](int i) HWY_ATTR {
      return hn::Add(hn::Set(d, rows.value[i][row]), hn::Mul(lane, hn::Set(d, rows.step[i][row])));
    };
    const MF covered = hn::FirstN(d, static_cast<size_t>(count));
    const VF depth = at_lanes(0);
    const MF shown = hn::And(covered, hn::Ge(depth, LoadDepth(covered, target.depth + place, count)));
    if (!hn::AllFalse(d, shown)) {
      VF s = at_lanes(2), t = at_lanes(3);
      if constexpr (kPerspective) {
        const VF z = hn::Div(hn::Set(d, 1.0f), hn::Max(depth, hn::Set(d, kMinDepth)));
        s = hn::Mul(s, z);
        t = hn::Mul(t, z);
      }
      const uint8_t shown_bits = StoreDepth(shown, depth, target.depth + place);
      io_segments.Add(place, count, shown_bits, SkinTexels(d, job, s, t),
                      BoundedLight(d, at_lanes(1), Pixel{}));
      if (!io_segments.has_room()) io_segments.Draw(job, static_cast<Pixel*>(target.pixels));
    }
    x += lanes;
  } while (x < end);
}

// The picture is larger than the first-level cache, and the next triangle may be anywhere.
template <typename Pixel>
HWY_INLINE void PrefetchRow(const RowList& rows, int32_t row, const TriangleTarget& target) {
  hwy::Prefetch(target.depth + rows.place[row]);
  hwy::Prefetch(static_cast<const Pixel*>(target.pixels) + rows.place[row]);
}

// Draws rows in the given order.
template <typename Pixel>
HWY_INLINE void DrawByRows(const TriangleJob& job, const RowList& rows, const int32_t* order, size_t count,
                           const TriangleTarget& target) {
  RowSegments segments;
  for (size_t i = 0; i < HWY_MIN(kRowsAhead, count); ++i) PrefetchRow<Pixel>(rows, order[i], target);
  for (size_t i = 0; i < count; ++i) {
    PrefetchRow<Pixel>(rows, order[HWY_MIN(i + kRowsAhead, count - 1)], target);
    const size_t row = static_cast<size_t>(order[i]);
    if (rows.perspective[row] != 0)
      DrawRow<Pixel, true>(job, rows, row, target, segments);
    else
      DrawRow<Pixel, false>(job, rows, row, target, segments);
  }
  segments.Draw(job, static_cast<Pixel*>(target.pixels));
}

// Pixels of a group of rows. Each vector has a pixel of each row.
struct PixelColumns {
  static constexpr size_t kMaxColumns = 8;
  static constexpr size_t kMaxPixels = RowList::kMaxGroupRows * kMaxColumns;

  HWY_ALIGN int32_t place[kMaxPixels], texel[kMaxPixels], light[kMaxPixels];
  HWY_ALIGN float depth[kMaxPixels];
  // A byte for each vector: its lanes that have a pixel. In words, because a load that is larger than the
  // stores before it waits for them.
  uint64_t covered[kMaxPixels / 2 / 8 + 1];
  size_t vectors;
};

HWY_INLINE uint64_t MaskBits(hn::Mask<DDI> mask) {
#if HWY_TARGET <= HWY_AVX3
  return mask.raw;
#else
  uint8_t bits[8] = {};
  hn::StoreMaskBits(DDI(), mask, bits);
  return bits[0];
#endif
}

// Computes the pixels of the rows from `first` up to `end`.
template <typename Pixel>
HWY_INLINE void FillColumns(const TriangleJob& job, const RowList& rows, size_t first, size_t end,
                            PixelColumns& out) {
  const DDF d;
  const DDI di;
  const size_t lanes = hn::Lanes(d);
  out.vectors = 0;
  out.covered[0] = 0;
  for (size_t row = first; row < end; row += lanes) {
    const auto count = hn::LoadU(di, rows.count + row), place = hn::LoadU(di, rows.place + row);
    const auto perspective = hn::MaskFromVec(hn::BitCast(d, hn::LoadU(di, rows.perspective + row)));
    const bool is_affine = hn::AllFalse(d, perspective);
    for (int x = 0;; ++x) {
      const auto covered = hn::Gt(count, hn::Set(di, x));
      if (hn::AllFalse(di, covered)) break;
      const auto column = hn::Set(d, static_cast<float>(x));
      const auto at_column = [&](int i) HWY_ATTR {
        return hn::Add(hn::LoadU(d, rows.value[i] + row), hn::Mul(column, hn::LoadU(d, rows.step[i] + row)));
      };
      const auto depth = at_column(0);
      auto s = at_column(2), t = at_column(3);
      if (!is_affine) {
        const auto z = hn::Div(hn::Set(d, 1.0f), hn::Max(depth, hn::Set(d, kMinDepth)));
        s = hn::IfThenElse(perspective, hn::Mul(s, z), s);
        t = hn::IfThenElse(perspective, hn::Mul(t, z), t);
      }
      const size_t at = out.vectors * lanes;
      hn::StoreU(hn::Add(place, hn::Set(di, x)), di, out.place + at);
      hn::StoreU(depth, d, out.depth + at);
      hn::StoreU(SkinTexels(d, job, s, t), di, out.texel + at);
      hn::StoreU(BoundedLight(d, at_column(1), Pixel{}), di, out.light + at);
      out.covered[out.vectors / 8] |= MaskBits(covered) << out.vectors % 8 * 8;
      if (++out.vectors % 8 == 0) out.covered[out.vectors / 8] = 0;
    }
  }
}

// Lists the covered pixels lane by lane, and so triangle by triangle. Returns their number.
HWY_INLINE size_t OrderPixels(const PixelColumns& pixels, int32_t* out) {
  const DI d;
  const size_t lanes = hn::Lanes(DDI());
  const auto* const covered = reinterpret_cast<const uint8_t*>(pixels.covered);
  const VI steps = hn::Mul(hn::Iota(d, 0), hn::Set(d, static_cast<int32_t>(lanes)));
  size_t count = 0;
  for (size_t lane = 0; lane < lanes; ++lane)
    for (size_t vector = 0; vector < pixels.vectors; vector += hn::Lanes(d)) {
      const VI bits = hn::PromoteTo(d, hn::LoadU(D8(), covered + vector));
      const auto is_covered = hn::TestBit(bits, hn::Set(d, 1 << lane));
      const VI numbers = hn::Add(steps, hn::Set(d, static_cast<int32_t>(vector * lanes + lane)));
      hn::StoreU(hn::Compress(numbers, is_covered), d, out + count);
      count += hn::CountTrue(d, is_covered);
    }
  return count;
}

// Calls show(place, number) for each visible pixel, in order, after its depth is written.
template <typename Show>
HWY_INLINE void TestPixels(const PixelColumns& pixels, const int32_t* order, size_t count, float* depth,
                           Show show) {
  for (size_t i = 0; i < count; ++i) {
    const int32_t number = order[i], place = pixels.place[number];
    if (!(pixels.depth[number] >= depth[place])) continue;
    depth[place] = pixels.depth[number];
    show(place, number);
  }
}

HWY_INLINE void DrawPixels(const TriangleJob& job, const PixelColumns& pixels, const int32_t* order,
                           size_t count, float* depth, uint8_t* out) {
  const auto* const colors = static_cast<const uint8_t*>(job.colors);
  TestPixels(pixels, order, count, depth, [&](int32_t place, int32_t number) HWY_ATTR {
    out[place] = colors[pixels.light[number] + job.skin[pixels.texel[number]]];
  });
}

HWY_INLINE void DrawPixels(const TriangleJob& job, const PixelColumns& pixels, const int32_t* order,
                           size_t count, float* depth, uint32_t* out) {
  const DU d;
  const auto* const table = static_cast<const uint32_t*>(job.colors);
  HWY_ALIGN uint32_t colors[PixelColumns::kMaxPixels];
  HWY_ALIGN int32_t light[PixelColumns::kMaxPixels], places[PixelColumns::kMaxPixels];
  size_t shown = 0;
  TestPixels(pixels, order, count, depth, [&](int32_t place, int32_t number) HWY_ATTR {
    places[shown] = place;
    light[shown] = pixels.light[number];
    colors[shown++] = table[job.skin[pixels.texel[number]]];
  });
  for (size_t i = 0; i < shown; i += hn::Lanes(d))
    hn::Store(LitColors(job, hn::Load(d, colors + i), hn::Load(DI(), light + i)), d, colors + i);
  for (size_t i = 0; i < shown; ++i) out[places[i]] = colors[i];
}

template <typename Pixel>
HWY_INLINE void DrawByColumns(const TriangleJob& job, const RowList& rows, size_t first, size_t end,
                              const TriangleTarget& target) {
  PixelColumns pixels;
  FillColumns<Pixel>(job, rows, first, end, pixels);
  HWY_ALIGN int32_t order[PixelColumns::kMaxPixels + 8];  // whole vectors are written
  const size_t count = OrderPixels(pixels, order);
  DrawPixels(job, pixels, order, count, target.depth, static_cast<Pixel*>(target.pixels));
}

HWY_INLINE bool FitColumns(const RowList& rows, size_t first, size_t end) {
  const DDI d;
  auto most = hn::Zero(d);
  for (size_t row = first; row < end; row += hn::Lanes(d))
    most = hn::Max(most, hn::LoadU(d, rows.count + row));
  return hn::AllFalse(d, hn::Gt(most, hn::Set(d, static_cast<int32_t>(PixelColumns::kMaxColumns))));
}

// Lists the rows of a group that have pixels, triangle by triangle. Returns their number.
HWY_INLINE size_t OrderRows(const RowList& rows, size_t first, size_t end, int32_t* out) {
  const size_t lanes = hn::Lanes(DDI());
  size_t ordered = 0;
  for (size_t lane = 0; lane < lanes; ++lane)
    for (size_t row = first + lane; row < end; row += lanes) {
      out[ordered] = static_cast<int32_t>(row);
      ordered += static_cast<size_t>(rows.count[row] > 0);
    }
  return ordered;
}

template <typename Pixel>
HWY_NOINLINE void DrawGroups(const TriangleJob& job, const RowList& rows, const TriangleTarget& target) {
  size_t first = 0, ahead = 0;
  for (size_t group = 0; group < rows.groups; ++group) {
    const size_t end = static_cast<size_t>(rows.group_end[group]);
    for (const size_t wanted = HWY_MIN(end + kRowsAhead, rows.size); ahead < wanted; ++ahead)
      PrefetchRow<Pixel>(rows, static_cast<int32_t>(ahead), target);
    if (FitColumns(rows, first, end)) {
      DrawByColumns<Pixel>(job, rows, first, end, target);
    } else {
      int32_t order[RowList::kMaxGroupRows];
      DrawByRows<Pixel>(job, rows, order, OrderRows(rows, first, end, order), target);
    }
    first = end;
  }
}

template <typename Pixel>
HWY_INLINE void DrawRows(const TriangleJob& job, const RowList& rows, const TriangleTarget& target) {
  if (job.has_short_rows)
    DrawGroups<Pixel>(job, rows, target);
  else
    DrawByRows<Pixel>(job, rows, rows.order, rows.ordered, target);
}

void DrawRowsU8(const TriangleJob& job, const RowList& rows, const TriangleTarget& target) {
  DrawRows<uint8_t>(job, rows, target);
}
void DrawRowsU32(const TriangleJob& job, const RowList& rows, const TriangleTarget& target) {
  DrawRows<uint32_t>(job, rows, target);
}

#endif

}  // namespace temblor::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace temblor::render {

HWY_EXPORT(DrawRowsU8);
HWY_EXPORT(DrawRowsU32);

void draw_rows_u8_simd(const TriangleJob& job, const RowList& rows, const TriangleTarget& target) {
  HWY_DYNAMIC_DISPATCH(DrawRowsU8)(job, rows, target);
}
void draw_rows_u32_simd(const TriangleJob& job, const RowList& rows, const TriangleTarget& target) {
  HWY_DYNAMIC_DISPATCH(DrawRowsU32)(job, rows, target);
}

}  // namespace temblor::render
#endif
