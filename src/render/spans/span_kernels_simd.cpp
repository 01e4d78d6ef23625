// Hot loop. The SIMD versions of span_kernels_scalar.cpp, compiled once for each instruction set. Lane i of a
// span is base + i * step, whatever the vector's width.
//
// A vector of pixels gets its texels in one of two ways:
//   window    if the texels lie within a few rows of a vector's width, those rows are loaded and the pixels
//             picked out of registers (FetchWindow)
//   gather    otherwise (FetchScattered)
#include "render/spans/span_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/spans/span_kernels_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace temblor::render::HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR

void DrawSurfaceSpansU8(const SurfaceSpans& spans, const KernelTarget& target) {
  draw_surface_spans_u8_scalar(spans, target);
}
void DrawSurfaceSpansU32(const SurfaceSpans& spans, const KernelTarget& target) {
  draw_surface_spans_u32_scalar(spans, target);
}
void DrawRepeatSpansU8(const RepeatSpans& spans, const KernelTarget& target) {
  draw_repeat_spans_u8_scalar(spans, target);
}
void DrawRepeatSpansU32(const RepeatSpans& spans, const KernelTarget& target) {
  draw_repeat_spans_u32_scalar(spans, target);
}
void DrawSkySpansU8(const SkySpans& spans, const KernelTarget& target) {
  draw_sky_spans_u8_scalar(spans, target);
}
void DrawSkySpansU32(const SkySpans& spans, const KernelTarget& target) {
  draw_sky_spans_u32_scalar(spans, target);
}

#else

namespace hn = hwy::HWY_NAMESPACE;

using DF = hn::CappedTag<float, 16>;
using DI = hn::Rebind<int32_t, DF>;
using DU = hn::RebindToUnsigned<DI>;
using D8 = hn::Rebind<uint8_t, DU>;
using VF = hn::Vec<DF>;
using VI = hn::Vec<DI>;

constexpr int kMaxLanes = 16;
// Pixels. For shorter spans, testing whether a span stays inside its texture costs more than the clamps it
// saves.
constexpr int kLongSpan = 96;

HWY_INLINE float At(const KernelPlane& plane, const Span& span) {
  return static_cast<float>(plane.at_origin + plane.dx * span.x + plane.dy * span.y);
}

// Stores the first `count` lanes only: later pixels may belong to another thread.
template <class D>
HWY_INLINE void StoreFirst(D d, hn::Vec<D> v, hn::TFromD<D>* out, int count) {
#if HWY_TARGET <= HWY_AVX3
  hn::BlendedStore(v, hn::FirstN(d, static_cast<size_t>(count)), d, out);
#else
  HWY_ALIGN hn::TFromD<D> lanes[kMaxLanes];
  hn::Store(v, d, lanes);
  for (int i = 0; i < count; ++i) out[i] = lanes[i];
#endif
}

// Converts to integers by adding a large float, which leaves the whole number in the low bits. Highway's
// ConvertTo guards against numbers that do not fit 32 bits, which these never are. The constant part of the
// sum is kBias; it cancels where two results are subtracted.
constexpr float kShift = 12582912.0f;  // 1.5 * 2^23: for numbers from -2^22 to 2^22
constexpr int kBias = 0x4b400000;
HWY_INLINE VI FloorBiased(VF v) {
#if HWY_TARGET <= HWY_AVX3  // an addition that rounds down does both at once
  return VI{_mm512_castps_si512(
      _mm512_add_round_ps(v.raw, _mm512_set1_ps(kShift), _MM_FROUND_TO_NEG_INF | _MM_FROUND_NO_EXC))};
#else
  return hn::BitCast(DI(), hn::Add(hn::Floor(v), hn::Set(DF(), kShift)));
#endif
}

// The column and row of each pixel's texel, plus kBias.
struct TexelLanes {
  VI column, row;
};

// The layout of a texture in memory.
struct Rows {
  int texels_per_row, last_row;
};

// Converts coordinates to texels, clamped to the block. kInside: known to be inside, so nothing is clamped.
struct Sampler {
  VF last_s, last_t;
  Rows rows;

  template <bool kInside>
  HWY_INLINE TexelLanes At(VF s, VF t) const {
    if constexpr (kInside) return {FloorBiased(s), FloorBiased(t)};
    const VF zero = hn::Zero(DF());
    return {FloorBiased(hn::Min(hn::Max(s, zero), last_s)), FloorBiased(hn::Min(hn::Max(t, zero), last_t))};
  }
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
    const VF lane = hn::Add(hn::Iota(d, 0.0f), hn::Set(d, static_cast<float>(first)));
    return hn::Add(hn::Set(d, base), hn::Mul(lane, hn::Set(d, step)));
  }
};

struct SpanLines {
  Line depth, s, t;
};

// How a span crosses the texture: s / depth changes by s_change * z * z per pixel, and t likewise (the
// quotient rule).
struct Walk {
  float s_change, t_change;

  HWY_INLINE explicit Walk(const SpanLines& lines)
      : s_change(lines.s.step * lines.depth.base - lines.s.base * lines.depth.step),
        t_change(lines.t.step * lines.depth.base - lines.t.base * lines.depth.step) {}
  HWY_INLINE Direction Way() const { return {s_change < 0, t_change < 0}; }
  // Whether both ends are inside the texture. Then all pixels between are, too, since coordinates are
  // monotonic; a margin compensates for rounding.
  HWY_INLINE bool Inside(const SpanLines& lines, const SurfaceSpans& spans, int count) const {
    constexpr float kMargin = 1.0f / 64;
    const float end = static_cast<float>(count - 1);
    const float last_depth = lines.depth.base + end * lines.depth.step;
    // The margin suffices for numbers of similar size; a large change of depth along a span would increase
    // the rounding errors.
    constexpr float kMaxRatio = 16;
    if (last_depth > lines.depth.base * kMaxRatio || lines.depth.base > last_depth * kMaxRatio) return false;
    const float first_z = 1.0f / lines.depth.base, last_z = 1.0f / last_depth;
    const float first_s = lines.s.base * first_z, last_s = (lines.s.base + end * lines.s.step) * last_z;
    const float first_t = lines.t.base * first_z, last_t = (lines.t.base + end * lines.t.step) * last_z;
    const float max_s = static_cast<float>(spans.last_s) + 1 - kMargin;
    const float max_t = static_cast<float>(spans.last_t) + 1 - kMargin;
    return first_s > kMargin && last_s > kMargin && first_t > kMargin && last_t > kMargin &&
           first_s < max_s && last_s < max_s && first_t < max_t && last_t < max_t;
  }
  // The number of rows of texels under a vector of pixels at the far end of the span, where texels are
  // densest (z squared is 1 / square): 2 or 4. 0: more than four, or more than one texel per pixel.
  HWY_INLINE int RowsNeeded(const SpanLines& lines, int count) const {
    const float last = lines.depth.base + static_cast<float>(count - 1) * lines.depth.step;
    const float least = last < lines.depth.base ? last : lines.depth.base;
    if (!(least > kMinSpanDepth)) return 0;
    const float square = least * least;
    const float columns = s_change < 0 ? -s_change : s_change;
    const float rows = (t_change < 0 ? -t_change : t_change) * (static_cast<float>(hn::Lanes(DF())) - 1.0f);
    return columns > square || rows > 3.0f * square ? 0 : rows > square ? 4 : 2;
  }
};

// The destination of a span's pixels and depth; `depth` may be null.
template <typename Texel>
struct SpanOutput {
  Texel* pixels;
  float* depth;
};

template <int kRows, bool kInside, typename Texel>
HWY_INLINE void DrawVector(const SpanLines& lines, const Sampler& sampler, Direction direction,
                           const Texel* texels, int i, int count, SpanOutput<Texel> out) {
  const DF d;
  const VF depth = lines.depth.Lanes(i);
  if (out.depth != nullptr) {
    if (count == static_cast<int>(hn::Lanes(d)))
      hn::StoreU(depth, d, out.depth + i);
    else
      StoreFirst(d, depth, out.depth + i, count);
  }
  const VF z = hn::Div(hn::Set(d, 1.0f), hn::Max(depth, hn::Set(d, kMinSpanDepth)));
  const TexelLanes at = sampler.At<kInside>(hn::Mul(lines.s.Lanes(i), z), hn::Mul(lines.t.Lanes(i), z));
  Fetch<kRows>(texels, sampler.rows, direction, at, out.pixels + i, count);
}

template <int kRows, bool kInside, typename Texel>
HWY_INLINE void DrawVectors(const SpanLines& lines, const Sampler& sampler, Direction direction,
                            const Texel* texels, int count, SpanOutput<Texel> out) {
  const int lanes = static_cast<int>(hn::Lanes(DF()));
  int i = 0;
  for (; i + lanes <= count; i += lanes)
    DrawVector<kRows, kInside>(lines, sampler, direction, texels, i, lanes, out);
  if (i < count) DrawVector<kRows, kInside>(lines, sampler, direction, texels, i, count - i, out);
}

template <typename Texel>
HWY_INLINE void DrawEveryPixel(const SpanLines& lines, const Sampler& sampler, const SurfaceSpans& spans,
                               int count, SpanOutput<Texel> out) {
  const Walk walk(lines);
  const Texel* texels = static_cast<const Texel*>(spans.texels);
  const int rows = walk.RowsNeeded(lines, count);
  const bool inside = count >= kLongSpan && rows > 0 && walk.Inside(lines, spans, count);
  if (rows == 2 && inside)
    DrawVectors<2, true>(lines, sampler, walk.Way(), texels, count, out);
  else if (rows == 2)
    DrawVectors<2, false>(lines, sampler, walk.Way(), texels, count, out);
  else if (rows == 4 && inside)
    DrawVectors<4, true>(lines, sampler, walk.Way(), texels, count, out);
  else if (rows == 4)
    DrawVectors<4, false>(lines, sampler, walk.Way(), texels, count, out);
  else
    DrawVectors<0, false>(lines, sampler, walk.Way(), texels, count, out);
}

HWY_INLINE void FillDepth(const Line& line, int count, float* out) {
  const DF d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  int i = 0;
  for (; i + lanes <= count; i += lanes) hn::StoreU(line.Lanes(i), d, out + i);
  if (i < count) StoreFirst(d, line.Lanes(i), out + i, count - i);
}

template <typename Texel>
HWY_INLINE void DrawAffine(const Line& s, const Line& t, const Sampler& sampler, const Texel* texels,
                           int count, Texel* out) {
  const DF d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  for (int i = 0; i < count; i += lanes) {
    const int now = count - i < lanes ? count - i : lanes;
    Fetch<4>(texels, sampler.rows, {s.step < 0, t.step < 0}, sampler.At<false>(s.Lanes(i), t.Lanes(i)),
             out + i, now);
  }
}

// Exact at both ends of every sixteen pixels, affine in between.
template <typename Texel>
HWY_INLINE void DrawEvery16(const SpanLines& lines, const Sampler& sampler, const Texel* texels, int count,
                            Texel* out) {
  const auto z_at = [&](float lane) {
    const float depth = lines.depth.base + lane * lines.depth.step;
    return 1.0f / (depth > kMinSpanDepth ? depth : kMinSpanDepth);
  };
  for (int first = 0; first < count; first += kAffinePixels) {
    const int now = count - first < kAffinePixels ? count - first : kAffinePixels;
    const float lane = static_cast<float>(first), end = static_cast<float>(first + now - 1);
    const float z_first = z_at(lane), z_end = z_at(end);
    const float pixels = static_cast<float>(now > 1 ? now - 1 : 1);
    Line s, t;
    s.base = (lines.s.base + lane * lines.s.step) * z_first;
    t.base = (lines.t.base + lane * lines.t.step) * z_first;
    s.step = ((lines.s.base + end * lines.s.step) * z_end - s.base) / pixels;
    t.step = ((lines.t.base + end * lines.t.step) * z_end - t.base) / pixels;
    DrawAffine(s, t, sampler, texels, now, out + first);
  }
}

template <typename Texel>
HWY_INLINE void DrawSurfaceSpans(const SurfaceSpans& spans, const KernelTarget& target) {
  const DF d;
  const Sampler sampler{hn::Set(d, static_cast<float>(spans.last_s)),
                        hn::Set(d, static_cast<float>(spans.last_t)),
                        {spans.texels_per_row, spans.last_t}};
  const Texel* texels = static_cast<const Texel*>(spans.texels);
  SpanLines lines;
  lines.depth.step = static_cast<float>(spans.depth.dx);
  lines.s.step = static_cast<float>(spans.s.dx);
  lines.t.step = static_cast<float>(spans.t.dx);
  for (size_t i = 0; i < spans.span_count; ++i) {
    const Span& span = spans.spans[i];
    const size_t first = span.y * target.width + span.x;
    Texel* out = static_cast<Texel*>(target.pixels) + first;
    float* out_depth = target.depth == nullptr ? nullptr : target.depth + first;
    lines.depth.base = At(spans.depth, span);
    lines.s.base = At(spans.s, span);
    lines.t.base = At(spans.t, span);
    if (spans.divide == KernelDivide::kEveryPixel) {
      DrawEveryPixel(lines, sampler, spans, span.count, SpanOutput<Texel>{out, out_depth});
      continue;
    }
    if (out_depth != nullptr) FillDepth(lines.depth, span.count, out_depth);
    if (spans.divide == KernelDivide::kNone)
      DrawAffine(lines.s, lines.t, sampler, texels, span.count, out);
    else
      DrawEvery16(lines, sampler, texels, span.count, out);
  }
}

void DrawSurfaceSpansU8(const SurfaceSpans& spans, const KernelTarget& target) {
  DrawSurfaceSpans<uint8_t>(spans, target);
}
void DrawSurfaceSpansU32(const SurfaceSpans& spans, const KernelTarget& target) {
  DrawSurfaceSpans<uint32_t>(spans, target);
}

// Warped coordinates leave a narrow window soon: with eight lanes, gathering is faster.
constexpr int kRepeatingRows = hn::MaxLanes(DI()) < 16 ? 0 : 4;

// A texture that repeats: width and height are powers of two.
template <typename Texel>
struct Repeating {
  const Texel* texels;
  int width, height;

  HWY_INLINE void Fetch(VF s, VF t, Texel* out, int count) const {
    const DI di;
    const VI bias = hn::Set(di, kBias);
    const TexelLanes at{hn::Or(hn::And(FloorBiased(s), hn::Set(di, width - 1)), bias),
                        hn::Or(hn::And(FloorBiased(t), hn::Set(di, height - 1)), bias)};
    const size_t last = hn::Lanes(di) - 1;
    const Direction direction{hn::ExtractLane(at.column, last) < hn::GetLane(at.column),
                              hn::ExtractLane(at.row, last) < hn::GetLane(at.row)};
    const Rows rows{width, height - 1};
    temblor::render::HWY_NAMESPACE::Fetch<kRepeatingRows>(texels, rows, direction, at, out, count);
  }
};

template <typename Texel>
HWY_INLINE void DrawSkySpans(const SkySpans& sky, const KernelTarget& target) {
  const DF d;
  const DU du;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const Repeating<Texel> clouds{static_cast<const Texel*>(sky.clouds), sky.width, sky.height};
  const Repeating<Texel> back{static_cast<const Texel*>(sky.back), sky.width, sky.height};
  HWY_ALIGN Texel cloud_texels[kMaxLanes], back_texels[kMaxLanes];
  for (size_t r = 0; r < sky.span_count; ++r) {
    const Span& span = sky.spans[r];
    const size_t first = span.y * target.width + span.x;
    Texel* out = static_cast<Texel*>(target.pixels) + first;
    Line ray[3];
    for (int axis = 0; axis < 3; ++axis)
      ray[axis] = {static_cast<float>(sky.forward[axis] + sky.right[axis] * span.x + sky.down[axis] * span.y),
                   static_cast<float>(sky.right[axis])};
    if (target.depth != nullptr)
      FillDepth({At(sky.depth, span), static_cast<float>(sky.depth.dx)}, span.count, target.depth + first);
    for (int i = 0; i < span.count; i += lanes) {
      const VF x = ray[0].Lanes(i), y = ray[1].Lanes(i), z = hn::Mul(ray[2].Lanes(i), hn::Set(d, 3.0f));
      const VF square = hn::Add(hn::Add(hn::Mul(x, x), hn::Mul(y, y)), hn::Mul(z, z));
      const VF stretch = hn::Div(hn::Set(d, sky.scale), hn::Sqrt(square));
      const VF s = hn::Mul(x, stretch), t = hn::Mul(y, stretch);
      // Both layers are fetched for every pixel; which one shows is decided afterwards.
      clouds.Fetch(hn::Add(s, hn::Set(d, sky.clouds_s)), hn::Add(t, hn::Set(d, sky.clouds_t)), cloud_texels,
                   lanes);
      back.Fetch(hn::Add(s, hn::Set(d, sky.back_s)), hn::Add(t, hn::Set(d, sky.back_t)), back_texels, lanes);
      const auto cloud = LoadTexels(cloud_texels);
      const auto shown = hn::IfThenElse(hn::Eq(cloud, hn::Zero(du)), LoadTexels(back_texels), cloud);
      StoreTexels(shown, out + i, span.count - i < lanes ? span.count - i : lanes);
    }
  }
}

// See `swing` in span_kernels_scalar.cpp.
HWY_INLINE VF Swing(VF turns) {
  const DF d;
  const VF r = hn::Sub(turns, hn::Round(turns));
  const VF parabola =
      hn::Sub(hn::Mul(r, hn::Set(d, 8.0f)), hn::Mul(hn::Mul(r, hn::Abs(r)), hn::Set(d, 16.0f)));
  const VF bend = hn::Mul(hn::Sub(hn::Mul(parabola, hn::Abs(parabola)), parabola), hn::Set(d, 0.225f));
  return hn::Add(hn::Set(d, 1.0f), hn::Add(parabola, bend));
}

HWY_INLINE VF Bounded(VF texel) {
  const DF d;
  return hn::Min(hn::Max(texel, hn::Set(d, -kFarTexel)), hn::Set(d, kFarTexel));
}

template <typename Texel>
HWY_INLINE void DrawRepeatSpans(const RepeatSpans& repeat, const KernelTarget& target) {
  const DF d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const Repeating<Texel> texture{static_cast<const Texel*>(repeat.texels), repeat.width, repeat.height};
  const VF phase = hn::Set(d, repeat.phase), amplitude = hn::Set(d, repeat.amplitude);
  const VF turns_per_texel = hn::Set(d, repeat.turns_per_texel);
  for (size_t r = 0; r < repeat.span_count; ++r) {
    const Span& span = repeat.spans[r];
    const size_t first = span.y * target.width + span.x;
    Texel* out = static_cast<Texel*>(target.pixels) + first;
    const Line depth_line{At(repeat.depth, span), static_cast<float>(repeat.depth.dx)};
    const Line s_line{At(repeat.s, span), static_cast<float>(repeat.s.dx)};
    const Line t_line{At(repeat.t, span), static_cast<float>(repeat.t.dx)};
    if (target.depth != nullptr) FillDepth(depth_line, span.count, target.depth + first);
    for (int i = 0; i < span.count; i += lanes) {
      VF s = s_line.Lanes(i), t = t_line.Lanes(i);
      if (repeat.divide) {
        const VF z = hn::Div(hn::Set(d, 1.0f), hn::Max(depth_line.Lanes(i), hn::Set(d, kMinSpanDepth)));
        s = hn::Mul(s, z);
        t = hn::Mul(t, z);
      }
      s = Bounded(s);
      t = Bounded(t);
      if (repeat.amplitude != 0.0f) {
        const VF s_swing = Swing(hn::Mul(hn::Add(t, phase), turns_per_texel));
        t = hn::Add(t, hn::Mul(Swing(hn::Mul(hn::Add(s, phase), turns_per_texel)), amplitude));
        s = hn::Add(s, hn::Mul(s_swing, amplitude));
      }
      texture.Fetch(s, t, out + i, span.count - i < lanes ? span.count - i : lanes);
    }
  }
}

void DrawRepeatSpansU8(const RepeatSpans& spans, const KernelTarget& target) {
  DrawRepeatSpans<uint8_t>(spans, target);
}
void DrawRepeatSpansU32(const RepeatSpans& spans, const KernelTarget& target) {
  DrawRepeatSpans<uint32_t>(spans, target);
}

void DrawSkySpansU8(const SkySpans& spans, const KernelTarget& target) {
  DrawSkySpans<uint8_t>(spans, target);
}
void DrawSkySpansU32(const SkySpans& spans, const KernelTarget& target) {
  DrawSkySpans<uint32_t>(spans, target);
}

#endif

}  // namespace temblor::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace temblor::render {

HWY_EXPORT(DrawSurfaceSpansU8);
HWY_EXPORT(DrawSurfaceSpansU32);
HWY_EXPORT(DrawRepeatSpansU8);
HWY_EXPORT(DrawRepeatSpansU32);
HWY_EXPORT(DrawSkySpansU8);
HWY_EXPORT(DrawSkySpansU32);

void draw_surface_spans_u8_simd(const SurfaceSpans& spans, const KernelTarget& target) {
  HWY_DYNAMIC_DISPATCH(DrawSurfaceSpansU8)(spans, target);
}
void draw_surface_spans_u32_simd(const SurfaceSpans& spans, const KernelTarget& target) {
  HWY_DYNAMIC_DISPATCH(DrawSurfaceSpansU32)(spans, target);
}
void draw_repeat_spans_u8_simd(const RepeatSpans& spans, const KernelTarget& target) {
  HWY_DYNAMIC_DISPATCH(DrawRepeatSpansU8)(spans, target);
}
void draw_repeat_spans_u32_simd(const RepeatSpans& spans, const KernelTarget& target) {
  HWY_DYNAMIC_DISPATCH(DrawRepeatSpansU32)(spans, target);
}
void draw_sky_spans_u8_simd(const SkySpans& spans, const KernelTarget& target) {
  HWY_DYNAMIC_DISPATCH(DrawSkySpansU8)(spans, target);
}
void draw_sky_spans_u32_simd(const SkySpans& spans, const KernelTarget& target) {
  HWY_DYNAMIC_DISPATCH(DrawSkySpansU32)(spans, target);
}

}  // namespace temblor::render
#endif
