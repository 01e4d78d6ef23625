// Hot loop. The SIMD version of triangle_kernels_scalar.cpp, compiled once for each instruction set. Three
// phases, in which a vector's lanes are different things:
//
//   SetUp              lanes are triangles    gradients and sides
//   RowList::Add       lanes are rows         first pixel, length, and start values of each row
//   RowList::DrawRow   lanes are pixels       depth test; scalar code then looks up the texels (RowSegments)
//
// Each phase fills a list that the next one consumes, so that the unpredictable branches of one phase do not
// wait for the divisions of another.
#include "render/alias/triangle_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/alias/triangle_kernels_simd.cpp"
#include <hwy/cache_control.h>
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace temblor::render::HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR

void DrawTrianglesU8(const TriangleJob& job, const TriangleTarget& target) {
  draw_triangles_u8_scalar(job, target);
}
void DrawTrianglesU32(const TriangleJob& job, const TriangleTarget& target) {
  draw_triangles_u32_scalar(job, target);
}

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
// Vectors of rows.
using DD = hn::CappedTag<double, 8>;
using DDF = hn::Rebind<float, DD>;
using DDI = hn::Rebind<int32_t, DD>;
using VD = hn::Vec<DD>;
using VDF = hn::Vec<DDF>;

// The distance, in rows of the list, at which the destination is prefetched.
constexpr size_t kRowsAhead = 24;
constexpr float kMinDepth = 1e-20f;

// The setup of several triangles, each in its own lane.
struct Setups {
  static constexpr int kCapacity = 8;

  HWY_ALIGN int32_t corners[3][kCapacity];
  // A side as an endless line. The first column right of it in a row is ceil((numerator + row * step) /
  // denominator), of integers. A side bounds rows either on the left or on the right; the bias moves its
  // column out of the way for the other bound, and for both bounds if the side is level.
  HWY_ALIGN double numerator[3][kCapacity], step[3][kCapacity], denominator[3][kCapacity];
  HWY_ALIGN double left_bias[3][kCapacity], right_bias[3][kCapacity];
  HWY_ALIGN double corner_x[kCapacity], corner_y[kCapacity];
  // The values at a corner, and the gradients, of depth, light, s, and t.
  HWY_ALIGN double at_corner[4][kCapacity], dx[4][kCapacity], dy[4][kCapacity];
  HWY_ALIGN int32_t perspective[kCapacity];
};

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

// Rows that have pixels, in drawing order. They are listed before any of them is drawn: the number of rows
// and pixels of a triangle is unpredictable, and a branch that depends on it would stall until the triangle's
// divisions are done.
class RowList {
 public:
  bool has_room() const { return size_ < kCapacity; }
  // Adds those of the next few rows, from `row` up to `end`, that have pixels: as many as a vector has lanes.
  HWY_INLINE void Add(const Setups& setups, int triangle, int row, int end, const TriangleTarget& target);
  template <typename Pixel>
  HWY_INLINE void Draw(const TriangleJob& job, const TriangleTarget& target);

 private:
  template <typename Pixel, bool kPerspective>
  HWY_INLINE void DrawRow(const TriangleJob& job, size_t row, const TriangleTarget& target,
                          RowSegments& io_segments) const;

  static constexpr size_t kCapacity = 256, kSpare = 16;  // whole vectors are written behind the last row
  HWY_ALIGN int32_t place_[kCapacity + kSpare];          // of its first pixel in the target
  HWY_ALIGN int32_t count_[kCapacity + kSpare], perspective_[kCapacity + kSpare];
  HWY_ALIGN float value_[4][kCapacity + kSpare], step_[4][kCapacity + kSpare];  // depth, light, s, t
  size_t size_ = 0;
  RowSegments segments_;
};

HWY_INLINE VDF Least(VDF a, VDF b, VDF c) {
  return hn::Min(hn::Min(a, b), c);
}
HWY_INLINE VDF Range(VDF a, VDF b, VDF c) {
  return hn::Sub(hn::Max(hn::Max(a, b), c), Least(a, b, c));
}

struct Corner {
  VD x, y;
  VDF depth, light, s, t;
};

// Gathers one corner of several triangles, field by field, from arrays of records.
HWY_INLINE Corner LoadCorner(const TriangleJob& job, const int32_t* corners) {
  const DD d;
  const DDF df;
  const DDI di;
  static_assert(sizeof(ScreenVertex) == 16 && sizeof(TexelPoint) == 8);
  const auto vertex = hn::ShiftLeft<2>(hn::Load(di, corners)),
             texel = hn::ShiftLeft<1>(hn::Load(di, corners));
  const auto* const wholes = &job.vertices->x;
  const auto* const floats = &job.vertices->depth;
  return {hn::PromoteTo(d, hn::GatherIndex(di, wholes, vertex)),
          hn::PromoteTo(d, hn::GatherIndex(di, wholes + 1, vertex)),
          hn::GatherIndex(df, floats, vertex),
          hn::GatherIndex(df, floats + 1, vertex),
          hn::GatherIndex(df, &job.texels->s, texel),
          hn::GatherIndex(df, &job.texels->s + 1, texel)};
}

HWY_INLINE void SetUpSide(const Corner& from, const Corner& to, int side, int lane, Setups& out) {
  const DD d;
  const VD zero = hn::Zero(d), nowhere = hn::Set(d, 1e9);
  const VD dx = hn::Sub(to.x, from.x), dy = hn::Sub(to.y, from.y);
  const auto goes_up = hn::Lt(dy, zero), is_level = hn::Eq(dy, zero);
  const VD sign = hn::IfThenElse(goes_up, hn::Set(d, -1.0), hn::Set(d, 1.0));
  const VD scaled = hn::Mul(sign, hn::Set(d, kSubpixels));
  const VD numerator = hn::Sub(hn::Mul(from.x, dy), hn::Mul(from.y, dx));
  hn::Store(hn::IfThenZeroElse(is_level, hn::Mul(numerator, sign)), d, out.numerator[side] + lane);
  hn::Store(hn::IfThenZeroElse(is_level, hn::Mul(dx, scaled)), d, out.step[side] + lane);
  hn::Store(hn::IfThenElse(is_level, hn::Set(d, 1.0), hn::Mul(dy, scaled)), d, out.denominator[side] + lane);
  // Corners are clockwise, so the triangle is to the right of a side that goes up.
  hn::Store(hn::IfThenElse(goes_up, zero, hn::Neg(nowhere)), d, out.left_bias[side] + lane);
  hn::Store(hn::IfThenElse(hn::Gt(dy, zero), zero, nowhere), d, out.right_bias[side] + lane);
}

// Computes the setup of as many triangles as a vector has lanes, from `lane` on.
HWY_INLINE void SetUp(const TriangleJob& job, int lane, Setups& io_setups) {
  const DD d;
  const DDF df;
  const Corner a = LoadCorner(job, io_setups.corners[0] + lane);
  const Corner b = LoadCorner(job, io_setups.corners[1] + lane);
  const Corner c = LoadCorner(job, io_setups.corners[2] + lane);
  SetUpSide(a, b, 0, lane, io_setups);
  SetUpSide(b, c, 1, lane, io_setups);
  SetUpSide(c, a, 2, lane, io_setups);

  const VD bx = hn::Sub(b.x, a.x), by = hn::Sub(b.y, a.y), cx = hn::Sub(c.x, a.x), cy = hn::Sub(c.y, a.y);
  const VD cross = hn::Sub(hn::Mul(bx, cy), hn::Mul(cx, by));
  const VD to_pixels = hn::Div(hn::Set(d, kSubpixels), cross);
  const VD x1 = hn::Mul(bx, to_pixels), y1 = hn::Mul(by, to_pixels);
  const VD x2 = hn::Mul(cx, to_pixels), y2 = hn::Mul(cy, to_pixels);
  const VD pixel = hn::Set(d, 1.0 / kSubpixels);
  hn::Store(hn::Mul(a.x, pixel), d, io_setups.corner_x + lane);
  hn::Store(hn::Mul(a.y, pixel), d, io_setups.corner_y + lane);

  const VDF farthest = Least(a.depth, b.depth, c.depth);
  const VDF texels = hn::Max(Range(a.s, b.s, c.s), Range(a.t, b.t, c.t));
  const VDF bend = hn::Mul(texels, Range(a.depth, b.depth, c.depth));
  const VDF most = job.perspective ? hn::Mul(hn::Set(df, 4 * kAffineErrorTexels), farthest)
                                   : hn::Set(df, hwy::HighestValue<float>());
  const auto perspective = hn::Gt(bend, most);
  hn::Store(hn::BitCast(DDI(), hn::VecFromMask(df, perspective)), DDI(), io_setups.perspective + lane);

  const auto gradient = [&](int i, VD v0, VD v1, VD v2) HWY_ATTR {
    const VD along1 = hn::Sub(v1, v0), along2 = hn::Sub(v2, v0);
    hn::Store(v0, d, io_setups.at_corner[i] + lane);
    hn::Store(hn::Sub(hn::Mul(along1, y2), hn::Mul(along2, y1)), d, io_setups.dx[i] + lane);
    hn::Store(hn::Sub(hn::Mul(along2, x1), hn::Mul(along1, x2)), d, io_setups.dy[i] + lane);
  };
  const auto weigh = [&](VDF value, VDF depth) HWY_ATTR {
    const VDF weight = hn::IfThenElse(perspective, depth, hn::Set(df, 1.0f));
    return hn::Mul(hn::PromoteTo(d, value), hn::PromoteTo(d, weight));
  };
  gradient(0, hn::PromoteTo(d, a.depth), hn::PromoteTo(d, b.depth), hn::PromoteTo(d, c.depth));
  gradient(1, hn::PromoteTo(d, a.light), hn::PromoteTo(d, b.light), hn::PromoteTo(d, c.light));
  gradient(2, weigh(a.s, a.depth), weigh(b.s, b.depth), weigh(c.s, c.depth));
  gradient(3, weigh(a.t, a.depth), weigh(b.t, b.depth), weigh(c.t, c.depth));
}

HWY_INLINE void RowList::Add(const Setups& setups, int triangle, int row, int end,
                             const TriangleTarget& target) {
  const DD d;
  const DDF df;
  const DDI di;
  const VD y = hn::Add(hn::Set(d, static_cast<double>(row)), hn::Iota(d, 0.0));
  const VD zero = hn::Zero(d), width = hn::Set(d, static_cast<double>(target.width));
  VD left = zero, right = width;
  for (int i = 0; i < 3; ++i) {
    const auto of = [&](const double(&values)[3][Setups::kCapacity])
                        HWY_ATTR { return hn::Set(d, values[i][triangle]); };
    const VD numerator = hn::Add(of(setups.numerator), hn::Mul(of(setups.step), y));
    const VD column = hn::Ceil(hn::Div(numerator, of(setups.denominator)));
    left = hn::Max(left, hn::Add(column, of(setups.left_bias)));
    right = hn::Min(right, hn::Add(column, of(setups.right_bias)));
  }
  left = hn::Min(left, width);
  right = hn::Max(right, zero);
  const VD from_x = hn::Sub(left, hn::Set(d, setups.corner_x[triangle]));
  const VD from_y = hn::Sub(y, hn::Set(d, setups.corner_y[triangle]));
  const VD rows_above = hn::Sub(y, hn::Set(d, static_cast<double>(target.first_row)));
  const auto count = hn::DemoteTo(di, hn::Sub(right, left));
  const auto has_pixels = hn::And(hn::Gt(count, hn::Zero(di)), hn::Lt(hn::Iota(di, row), hn::Set(di, end)));
  const auto place = hn::DemoteTo(di, hn::Add(hn::Mul(rows_above, width), left));
  hn::StoreU(hn::Compress(place, has_pixels), di, place_ + size_);
  hn::StoreU(hn::Compress(count, has_pixels), di, count_ + size_);
  hn::StoreU(hn::Set(di, setups.perspective[triangle]), di, perspective_ + size_);
  for (int i = 0; i < 4; ++i) {
    const double dx = setups.dx[i][triangle];
    const VD along = hn::Add(hn::Set(d, setups.at_corner[i][triangle]), hn::Mul(hn::Set(d, dx), from_x));
    const VD value = hn::Add(along, hn::Mul(hn::Set(d, setups.dy[i][triangle]), from_y));
    hn::StoreU(hn::Compress(hn::DemoteTo(df, value), hn::RebindMask(df, has_pixels)), df, value_[i] + size_);
    hn::StoreU(hn::Set(df, static_cast<float>(dx)), df, step_[i] + size_);
  }
  size_ += hn::CountTrue(di, has_pixels);
}

// Truncates. Highway's ConvertTo guards against numbers that do not fit 32 bits, which these never are.
HWY_INLINE VI ToWhole(VF v) {
#if HWY_TARGET <= HWY_AVX3
  return VI{_mm256_cvttps_epi32(v.raw)};
#else
  return hn::ConvertTo(DI(), v);
#endif
}

// The position of each lane's texel in the skin.
HWY_INLINE VI SkinTexels(const TriangleJob& job, VF s, VF t) {
  const DF d;
  const VF last_s = hn::Set(d, static_cast<float>(job.skin_width - 1));
  const VF last_t = hn::Set(d, static_cast<float>(job.skin_height - 1));
  const VI column = ToWhole(hn::Max(hn::Min(s, last_s), hn::Zero(d)));
  const VI row = ToWhole(hn::Max(hn::Min(t, last_t), hn::Zero(d)));
  return hn::Add(hn::Mul(row, hn::Set(DI(), job.skin_width)), column);
}

HWY_INLINE VI BoundedLight(VF light, uint8_t) {
  const DF d;
  const VI whole = ToWhole(hn::Max(hn::Min(light, hn::Set(d, kDarkestRow)), hn::Zero(d)));
  return hn::And(whole, hn::Set(DI(), ~255));
}
HWY_INLINE VI BoundedLight(VF light, uint32_t) {
  const DF d;
  return ToWhole(hn::Max(hn::Min(light, hn::Set(d, kBrightestLight)), hn::Zero(d)));
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
HWY_INLINE void RowList::DrawRow(const TriangleJob& job, size_t row, const TriangleTarget& target,
                                 RowSegments& io_segments) const {
  const DF d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const int end = count_[row];
  int x = 0;
  do {
    const int count = HWY_MIN(end - x, lanes), place = place_[row] + x;
    const VF lane = hn::Add(hn::Iota(d, 0.0f), hn::Set(d, static_cast<float>(x)));
    const auto at_lanes = [&](int i) HWY_ATTR {
      return hn::Add(hn::Set(d, value_[i][row]), hn::Mul(lane, hn::Set(d, step_[i][row])));
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
      io_segments.Add(place, count, shown_bits, SkinTexels(job, s, t), BoundedLight(at_lanes(1), Pixel{}));
      if (!io_segments.has_room()) io_segments.Draw(job, static_cast<Pixel*>(target.pixels));
    }
    x += lanes;
  } while (x < end);
}

template <typename Pixel>
HWY_INLINE void RowList::Draw(const TriangleJob& job, const TriangleTarget& target) {
  for (size_t row = 0; row < size_; ++row) {
    // The picture is larger than the first-level cache, and the next triangle may be anywhere.
    const int ahead = place_[HWY_MIN(row + kRowsAhead, size_ - 1)];
    hwy::Prefetch(target.depth + ahead);
    hwy::Prefetch(static_cast<const Pixel*>(target.pixels) + ahead);
    if (perspective_[row] != 0)
      DrawRow<Pixel, true>(job, row, target, segments_);
    else
      DrawRow<Pixel, false>(job, row, target, segments_);
  }
  size_ = 0;
  segments_.Draw(job, static_cast<Pixel*>(target.pixels));
}

template <typename Pixel>
HWY_INLINE void DrawTriangles(const TriangleJob& job, const TriangleTarget& target) {
  // Triangles that touch the target's rows are collected first, branchless.
  constexpr size_t kBatch = 256;
  const FrontTriangle* here[kBatch];
  const int at_once = static_cast<int>(hn::Lanes(DD()));
  Setups setups;
  RowList rows;
  for (size_t begin = 0; begin < job.front_count; begin += kBatch) {
    const size_t end = HWY_MIN(begin + kBatch, job.front_count);
    size_t count = 0;
    for (size_t i = begin; i < end; ++i) {
      here[count] = job.fronts + i;
      count += static_cast<size_t>(job.fronts[i].row_end > target.row_begin) &
               static_cast<size_t>(job.fronts[i].first_row < target.row_end);
    }
    for (size_t first = 0; first < count; first += Setups::kCapacity) {
      const int triangles = static_cast<int>(HWY_MIN(count - first, size_t{Setups::kCapacity}));
      for (int i = 0; i < Setups::kCapacity; ++i)
        for (int corner = 0; corner < 3; ++corner)
          setups.corners[corner][i] = static_cast<int32_t>(
              here[first + static_cast<size_t>(HWY_MIN(i, triangles - 1))]->corners[corner]);
      for (int lane = 0; lane < triangles; lane += at_once) SetUp(job, lane, setups);
      for (int i = 0; i < triangles; ++i) {
        const FrontTriangle& triangle = *here[first + static_cast<size_t>(i)];
        const int row_end = HWY_MIN(triangle.row_end, target.row_end);
        for (int y = HWY_MAX(triangle.first_row, target.row_begin); y < row_end; y += at_once) {
          rows.Add(setups, i, y, row_end, target);
          if (!rows.has_room()) rows.Draw<Pixel>(job, target);
        }
      }
    }
  }
  rows.Draw<Pixel>(job, target);
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

void draw_triangles_u8_simd(const TriangleJob& job, const TriangleTarget& target) {
  HWY_DYNAMIC_DISPATCH(DrawTrianglesU8)(job, target);
}
void draw_triangles_u32_simd(const TriangleJob& job, const TriangleTarget& target) {
  HWY_DYNAMIC_DISPATCH(DrawTrianglesU32)(job, target);
}

}  // namespace temblor::render
#endif
