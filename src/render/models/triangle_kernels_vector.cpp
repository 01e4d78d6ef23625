// Hot loop. The vector twin of triangle_kernels_plain.cpp, compiled once for each instruction set. Rows of a
// triangle are lanes while it is found where each begins and ends and what stands at its first pixel; then
// pixels are.
#include "render/models/triangle_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/models/triangle_kernels_vector.cpp"
#include <hwy/cache_control.h>
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace temblor::render::HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR

void DrawTrianglesU8(const TriangleJob& job, const TriangleTarget& target) {
  draw_triangles_u8_plain(job, target);
}
void DrawTrianglesU32(const TriangleJob& job, const TriangleTarget& target) {
  draw_triangles_u32_plain(job, target);
}

#else

namespace hn = hwy::HWY_NAMESPACE;

// Rows of most triangles are shorter than eight pixels; wider vectors would work on nothing.
using DF = hn::CappedTag<float, 8>;
using DI = hn::Rebind<int32_t, DF>;
using DU = hn::RebindToUnsigned<DI>;
using D8 = hn::Rebind<uint8_t, DU>;
using VF = hn::Vec<DF>;
using VI = hn::Vec<DI>;
using VU = hn::Vec<DU>;
using MF = hn::Mask<DF>;
// By row.
using DD = hn::CappedTag<double, 8>;
using DDF = hn::Rebind<float, DD>;
using DDI = hn::Rebind<int32_t, DD>;
using VD = hn::Vec<DD>;

constexpr int kMostRows = 8;
constexpr int kMostPrefetched = 16;  // rows
constexpr size_t kAhead = 6;         // triangles
constexpr float kLeastDepth = 1e-20f;

// A side seen as a line without ends: the columns right of it, row by row, are a quotient of whole numbers.
struct Side {
  double numerator, step, denominator;  // numerator: at row 0
  bool is_left;
};

struct Gradient {
  double at_corner, dx, dy;
};

struct Setup {
  Side sides[3];
  int side_count;
  int first_row, row_end;
  double corner_x, corner_y;
  Gradient gradients[4];  // depth, light, s, t
  bool perspective;
};

struct RowStarts {
  HWY_ALIGN int32_t first[kMostRows], end[kMostRows];
  HWY_ALIGN float value[4][kMostRows];
};

HWY_INLINE int64_t Cross(const ScreenVertex& a, const ScreenVertex& b, const ScreenVertex& c) {
  return (int64_t{b.x} - a.x) * (int64_t{c.y} - a.y) - (int64_t{c.x} - a.x) * (int64_t{b.y} - a.y);
}

HWY_INLINE int FirstPixel(int y) {
  return (y + (kSubpixels - 1)) >> 8;
}

HWY_INLINE float Least(float a, float b, float c) {
  return HWY_MIN(HWY_MIN(a, b), c);
}
HWY_INLINE float Most(float a, float b, float c) {
  return HWY_MAX(HWY_MAX(a, b), c);
}

HWY_INLINE bool NeedsPerspective(const ScreenVertex& a, const ScreenVertex& b, const ScreenVertex& c,
                                 const TexelPoint& ta, const TexelPoint& tb, const TexelPoint& tc) {
  const float farthest = Least(a.depth, b.depth, c.depth);
  const float depth_range = Most(a.depth, b.depth, c.depth) - farthest;
  const float s_range = Most(ta.s, tb.s, tc.s) - Least(ta.s, tb.s, tc.s);
  const float t_range = Most(ta.t, tb.t, tc.t) - Least(ta.t, tb.t, tc.t);
  return HWY_MAX(s_range, t_range) * depth_range > 4 * kAffineErrorTexels * farthest;
}

HWY_INLINE void AddSide(const ScreenVertex& from, const ScreenVertex& to, Setup& io_setup) {
  const int64_t dx = int64_t{to.x} - from.x, dy = int64_t{to.y} - from.y;
  if (dy == 0) return;
  // Going up, the triangle is to the right.
  const int64_t sign = dy < 0 ? -1 : 1;
  io_setup.sides[io_setup.side_count++] = {static_cast<double>((from.x * dy - from.y * dx) * sign),
                                           static_cast<double>(dx * kSubpixels * sign),
                                           static_cast<double>(dy * kSubpixels * sign), dy < 0};
}

HWY_INLINE Setup SetUp(const TriangleJob& job, const FrontTriangle& triangle, const TriangleTarget& target) {
  const uint32_t* const index = triangle.corners;
  const ScreenVertex &a = job.vertices[index[0]], &b = job.vertices[index[1]], &c = job.vertices[index[2]];
  const TexelPoint &ta = job.texels[index[0]], &tb = job.texels[index[1]], &tc = job.texels[index[2]];
  Setup setup;
  setup.first_row = HWY_MAX(triangle.first_row, target.row_begin);
  setup.row_end = HWY_MIN(triangle.row_end, target.row_end);
  setup.side_count = 0;
  AddSide(a, b, setup);
  AddSide(b, c, setup);
  AddSide(c, a, setup);

  const double to_pixels = kSubpixels / static_cast<double>(Cross(a, b, c));
  const double x1 = (b.x - a.x) * to_pixels, y1 = (b.y - a.y) * to_pixels;
  const double x2 = (c.x - a.x) * to_pixels, y2 = (c.y - a.y) * to_pixels;
  setup.corner_x = a.x * (1.0 / kSubpixels);
  setup.corner_y = a.y * (1.0 / kSubpixels);
  setup.perspective = job.perspective && NeedsPerspective(a, b, c, ta, tb, tc);
  const double wa = setup.perspective ? double{a.depth} : 1.0;
  const double wb = setup.perspective ? double{b.depth} : 1.0;
  const double wc = setup.perspective ? double{c.depth} : 1.0;
  const double values[4][3] = {{a.depth, b.depth, c.depth},
                               {a.light, b.light, c.light},
                               {ta.s * wa, tb.s * wb, tc.s * wc},
                               {ta.t * wa, tb.t * wb, tc.t * wc}};
  for (int i = 0; i < 4; ++i) {
    const double v0 = values[i][0], v1 = values[i][1], v2 = values[i][2];
    setup.gradients[i] = {v0, (v1 - v0) * y2 - (v2 - v0) * y1, (v2 - v0) * x1 - (v1 - v0) * x2};
  }
  return setup;
}

// Of the rows from `row` on, as many as a vector has.
HWY_INLINE void FindRows(const Setup& setup, int row, double width, RowStarts& out) {
  const DD d;
  const VD y = hn::Add(hn::Set(d, static_cast<double>(row)), hn::Iota(d, 0.0));
  const VD zero = hn::Zero(d), most = hn::Set(d, width);
  VD left = zero, right = most;
  for (int i = 0; i < setup.side_count; ++i) {
    const Side& side = setup.sides[i];
    const VD numerator = hn::Add(hn::Set(d, side.numerator), hn::Mul(hn::Set(d, side.step), y));
    const VD column = hn::Ceil(hn::Div(numerator, hn::Set(d, side.denominator)));
    if (side.is_left)
      left = hn::Max(left, column);
    else
      right = hn::Min(right, column);
  }
  left = hn::Min(left, most);
  right = hn::Max(right, zero);
  const VD from_x = hn::Sub(left, hn::Set(d, setup.corner_x));
  const VD from_y = hn::Sub(y, hn::Set(d, setup.corner_y));
  hn::StoreU(hn::DemoteTo(DDI(), left), DDI(), out.first);
  hn::StoreU(hn::DemoteTo(DDI(), right), DDI(), out.end);
  for (int i = 0; i < 4; ++i) {
    const Gradient& g = setup.gradients[i];
    const VD along = hn::Add(hn::Set(d, g.at_corner), hn::Mul(hn::Set(d, g.dx), from_x));
    const VD value = hn::Add(along, hn::Mul(hn::Set(d, g.dy), from_y));
    hn::StoreU(hn::DemoteTo(DDF(), value), DDF(), out.value[i]);
  }
}

// Towards zero. Highway's ConvertTo guards against numbers that do not fit 32 bits, which these never are.
HWY_INLINE VI ToWhole(VF v) {
#if HWY_TARGET <= HWY_AVX3
  return VI{_mm256_cvttps_epi32(v.raw)};
#else
  return hn::ConvertTo(DI(), v);
#endif
}

// The palette index at each lane.
HWY_INLINE VU SkinTexels(const TriangleJob& job, VF s, VF t) {
  const DF d;
  const VF last_s = hn::Set(d, static_cast<float>(job.skin_width - 1));
  const VF last_t = hn::Set(d, static_cast<float>(job.skin_height - 1));
  const VI column = ToWhole(hn::Max(hn::Min(s, last_s), hn::Zero(d)));
  const VI row = ToWhole(hn::Max(hn::Min(t, last_t), hn::Zero(d)));
  const VI offset = hn::Add(hn::Mul(row, hn::Set(DI(), job.skin_width)), column);
  // Three more bytes come along, and are cut off again.
  return hn::And(hn::GatherOffset(DU(), reinterpret_cast<const uint32_t*>(job.skin), offset),
                 hn::Set(DU(), 255));
}

HWY_INLINE VI BoundedLight(VF light, float most) {
  const DF d;
  return ToWhole(hn::Max(hn::Min(light, hn::Set(d, most)), hn::Zero(d)));
}

HWY_INLINE VU LitTexels(const TriangleJob& job, VU texels, VF light, uint8_t) {
  const VU row = hn::And(hn::BitCast(DU(), BoundedLight(light, kDarkestRow)), hn::Set(DU(), ~255u));
  const VI offset = hn::BitCast(DI(), hn::Or(row, texels));
  return hn::And(hn::GatherOffset(DU(), static_cast<const uint32_t*>(job.colours), offset),
                 hn::Set(DU(), 255));
}

HWY_INLINE VU LitTexels(const TriangleJob& job, VU texels, VF light, uint32_t) {
  const DU du;
  const DI di;
  const VU colour = hn::GatherIndex(du, static_cast<const uint32_t*>(job.colours), hn::BitCast(di, texels));
  const VI whole = BoundedLight(light, kBrightestLight);
  const VU opaque = hn::Set(du, 0xff000000u);
  const auto channel = [&](VU value, int tint) HWY_ATTR {
    const VI tinted = hn::ShiftRight<15>(hn::Mul(whole, hn::Set(di, tint)));
    const VI doubled = hn::BitCast(di, hn::Add(value, value));
    const VI lit = hn::ShiftRight<15>(hn::Add(hn::Mul(doubled, tinted), hn::Set(di, 16384)));
    return hn::BitCast(du, hn::Min(lit, hn::Set(di, 255)));
  };
  const VU byte = hn::Set(du, 255);
  const VU red = channel(hn::And(hn::ShiftRight<16>(colour), byte), job.tint[0]);
  const VU green = channel(hn::And(hn::ShiftRight<8>(colour), byte), job.tint[1]);
  const VU blue = channel(hn::And(colour, byte), job.tint[2]);
  const VU lit = hn::Or(hn::Or(hn::ShiftLeft<16>(red), hn::ShiftLeft<8>(green)), blue);
  const auto is_lit = hn::Ne(hn::And(colour, opaque), hn::Zero(du));
  return hn::Or(opaque, hn::IfThenElse(is_lit, lit, colour));
}

#if HWY_TARGET <= HWY_AVX3

HWY_INLINE VF LoadDepth(MF covered, const float* depth, int) {
  return hn::MaskedLoad(covered, DF(), depth);
}
HWY_INLINE void StoreWhere(MF shown, VF depth, VU pixels, float* out_depth, uint8_t* out, int) {
  hn::BlendedStore(depth, shown, DF(), out_depth);
  // One instruction; TruncateTo takes several shuffles.
  const hn::Vec<D8> bytes{_mm256_cvtepi32_epi8(pixels.raw)};
  hn::BlendedStore(bytes, hn::Mask<D8>{static_cast<__mmask16>(shown.raw)}, D8(), out);
}
HWY_INLINE void StoreWhere(MF shown, VF depth, VU pixels, float* out_depth, uint32_t* out, int) {
  hn::BlendedStore(depth, shown, DF(), out_depth);
  hn::BlendedStore(pixels, hn::RebindMask(DU(), shown), DU(), out);
}

#else

// Neighbouring pixels may be another band's: not even what was there may be written to them.
HWY_INLINE VF LoadDepth(MF, const float* depth, int count) {
  HWY_ALIGN float lanes[8] = {};
  for (int i = 0; i < count; ++i) lanes[i] = depth[i];
  return hn::Load(DF(), lanes);
}
template <typename Pixel>
HWY_INLINE void StoreWhere(MF shown, VF depth, VU pixels, float* out_depth, Pixel* out, int count) {
  HWY_ALIGN float depths[8];
  HWY_ALIGN uint32_t colours[8];
  HWY_ALIGN uint32_t flags[8];
  hn::Store(depth, DF(), depths);
  hn::Store(pixels, DU(), colours);
  hn::Store(hn::BitCast(DU(), hn::VecFromMask(DF(), shown)), DU(), flags);
  for (int i = 0; i < count; ++i)
    if (flags[i] != 0) {
      out_depth[i] = depths[i];
      out[i] = static_cast<Pixel>(colours[i]);
    }
}

#endif

// A pixel's values are those of its row's first pixel and `lane` steps more.
struct Steps {
  VF depth, light, s, t;

  HWY_INLINE Steps AtLanes(VF lane) const {
    return {hn::Mul(lane, depth), hn::Mul(lane, light), hn::Mul(lane, s), hn::Mul(lane, t)};
  }
};

template <typename Pixel, bool kPerspective>
HWY_INLINE void DrawPixels(const TriangleJob& job, const RowStarts& rows, int row, const Steps& offsets,
                           int count, Pixel* HWY_RESTRICT pixels, float* HWY_RESTRICT nearest) {
  const DF d;
  const MF covered = hn::FirstN(d, static_cast<size_t>(count));
  const VF depth = hn::Add(hn::Set(d, rows.value[0][row]), offsets.depth);
  const MF shown = hn::And(covered, hn::Ge(depth, LoadDepth(covered, nearest, count)));
  if (hn::AllFalse(d, shown)) return;
  const VF light = hn::Add(hn::Set(d, rows.value[1][row]), offsets.light);
  VF s = hn::Add(hn::Set(d, rows.value[2][row]), offsets.s);
  VF t = hn::Add(hn::Set(d, rows.value[3][row]), offsets.t);
  if constexpr (kPerspective) {
    const VF z = hn::Div(hn::Set(d, 1.0f), hn::Max(depth, hn::Set(d, kLeastDepth)));
    s = hn::Mul(s, z);
    t = hn::Mul(t, z);
  }
  const VU colours = LitTexels(job, SkinTexels(job, s, t), light, Pixel{});
  StoreWhere(shown, depth, colours, nearest, pixels, count);
}

template <typename Pixel, bool kPerspective>
HWY_INLINE void DrawRows(const TriangleJob& job, const Setup& setup, const TriangleTarget& target) {
  const DF d;
  const Steps steps = {hn::Set(d, static_cast<float>(setup.gradients[0].dx)),
                       hn::Set(d, static_cast<float>(setup.gradients[1].dx)),
                       hn::Set(d, static_cast<float>(setup.gradients[2].dx)),
                       hn::Set(d, static_cast<float>(setup.gradients[3].dx))};
  const int lanes = static_cast<int>(hn::Lanes(d));
  const Steps first_offsets = steps.AtLanes(hn::Iota(d, 0.0f));
  const int rows_at_once = static_cast<int>(hn::Lanes(DD()));
  const double width = target.width;
  RowStarts rows;
  for (int y = setup.first_row; y < setup.row_end; y += rows_at_once) {
    FindRows(setup, y, width, rows);
    const int count = HWY_MIN(rows_at_once, setup.row_end - y);
    for (int row = 0; row < count; ++row) {
      const int pixels = rows.end[row] - rows.first[row];
      if (pixels <= 0) continue;
      const size_t first =
          static_cast<size_t>(y + row - target.first_row) * static_cast<size_t>(target.width) +
          static_cast<size_t>(rows.first[row]);
      Pixel* const row_pixels = static_cast<Pixel*>(target.pixels) + first;
      float* const row_depth = target.depth + first;
      DrawPixels<Pixel, kPerspective>(job, rows, row, first_offsets, HWY_MIN(pixels, lanes), row_pixels,
                                      row_depth);
      for (int x = lanes; x < pixels; x += lanes) {
        const VF lane = hn::Add(hn::Iota(d, 0.0f), hn::Set(d, static_cast<float>(x)));
        DrawPixels<Pixel, kPerspective>(job, rows, row, steps.AtLanes(lane), HWY_MIN(pixels - x, lanes),
                                        row_pixels + x, row_depth + x);
      }
    }
  }
}

// Asks for the rows that a triangle will be drawn to: the picture is larger than the near caches, and no
// pattern tells the processor where the next triangle lies.
template <typename Pixel>
HWY_INLINE void PrefetchRows(const TriangleJob& job, const FrontTriangle& triangle,
                             const TriangleTarget& target) {
  const uint32_t* const index = triangle.corners;
  const ScreenVertex &a = job.vertices[index[0]], &b = job.vertices[index[1]], &c = job.vertices[index[2]];
  const int first_row = HWY_MAX(triangle.first_row, target.row_begin);
  const int row_end = HWY_MIN(triangle.row_end, target.row_end);
  const int x = HWY_MAX(FirstPixel(HWY_MIN(HWY_MIN(a.x, b.x), c.x)), 0);
  if (x >= target.width) return;
  size_t pixel = static_cast<size_t>(first_row - target.first_row) * static_cast<size_t>(target.width) +
                 static_cast<size_t>(x);
  const int rows = HWY_MIN(row_end - first_row, kMostPrefetched);
  for (int row = 0; row < rows; ++row, pixel += static_cast<size_t>(target.width)) {
    hwy::Prefetch(target.depth + pixel);
    hwy::Prefetch(static_cast<const Pixel*>(target.pixels) + pixel);
  }
}

template <typename Pixel>
HWY_INLINE void DrawTriangles(const TriangleJob& job, const TriangleTarget& target) {
  // Those of these rows are sorted out ahead, without a branch.
  constexpr size_t kBatch = 256;
  const FrontTriangle* here[kBatch];
  for (size_t begin = 0; begin < job.front_count; begin += kBatch) {
    const size_t end = HWY_MIN(begin + kBatch, job.front_count);
    size_t count = 0;
    for (size_t i = begin; i < end; ++i) {
      here[count] = job.fronts + i;
      count += static_cast<size_t>(job.fronts[i].row_end > target.row_begin) &
               static_cast<size_t>(job.fronts[i].first_row < target.row_end);
    }
    for (size_t i = 0; i < count; ++i) {
      if (i + kAhead < count) PrefetchRows<Pixel>(job, *here[i + kAhead], target);
      const Setup setup = SetUp(job, *here[i], target);
      if (setup.perspective)
        DrawRows<Pixel, true>(job, setup, target);
      else
        DrawRows<Pixel, false>(job, setup, target);
    }
  }
}

void DrawTrianglesU8(const TriangleJob& job, const TriangleTarget& target) {
  DrawTriangles<uint8_t>(job, target);
}
void DrawTrianglesU32(const TriangleJob& job, const TriangleTarget& target) {
  DrawTriangles<uint32_t>(job, target);
}

#endif

}  // namespace temblor::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace temblor::render {

HWY_EXPORT(DrawTrianglesU8);
HWY_EXPORT(DrawTrianglesU32);

void draw_triangles_u8_vector(const TriangleJob& job, const TriangleTarget& target) {
  HWY_DYNAMIC_DISPATCH(DrawTrianglesU8)(job, target);
}
void draw_triangles_u32_vector(const TriangleJob& job, const TriangleTarget& target) {
  HWY_DYNAMIC_DISPATCH(DrawTrianglesU32)(job, target);
}

}  // namespace temblor::render
#endif
