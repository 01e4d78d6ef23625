// Hot loop. The SIMD version of triangle_kernels_scalar.cpp, compiled once for each instruction set. Its
// phases, in which a vector's lanes are different things:
//
//   ListTriangles          lanes are triangles   corners, field by field
//   SetUp                  lanes are triangles   gradients and sides
//   RowList::AddTriangles  lanes are triangles   a row of each: first pixel, length, and start values
//   RowList::AddRows       lanes are rows        the same, for the rows of one taller triangle
//   RowList::DrawRow       lanes are pixels      depth test; scalar code then looks up the texels
//   (RowSegments)
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

// Triangles that touch the target's rows, field by field. They are listed long before they are set up: a
// vector that is loaded right after its parts were stored waits until all work before it is done.
struct TriangleList {
  static constexpr int kCapacity = 64;

  HWY_ALIGN int32_t x[3][kCapacity], y[3][kCapacity];  // by corner
  HWY_ALIGN float depth[3][kCapacity], light[3][kCapacity], s[3][kCapacity], t[3][kCapacity];
  HWY_ALIGN int32_t row[kCapacity], row_end[kCapacity];  // inside the target
  int size;
};

// The setup of several triangles, each in its own lane.
struct Setups {
  static constexpr int kCapacity = 8;

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
  // Whether there is room for eight more vectors of rows.
  bool has_room() const { return size_ <= kCapacity - 8 * 8; }
  // Adds the rows from `row` up to `end`, at most a vector of them, of one triangle.
  HWY_INLINE void AddRows(const Setups& setups, int triangle, int row, int end, const TriangleTarget& target);
  // Adds all rows, from `row` up to `end`, of a vector of triangles. None has more than `most` rows, at
  // most 8.
  HWY_INLINE void AddTriangles(const Setups& setups, hn::Vec<DDI> row, hn::Vec<DDI> end, int most,
                               const TriangleTarget& target);
  template <typename Pixel>
  HWY_NOINLINE void Draw(const TriangleJob& job, const TriangleTarget& target);

 private:
  template <typename Source>
  HWY_INLINE void Store(const Setups& setups, Source of, hn::Vec<DDI> rows, hn::Vec<DDI> end,
                        const TriangleTarget& target);
  template <typename Pixel, bool kPerspective>
  HWY_INLINE void DrawRow(const TriangleJob& job, size_t row, const TriangleTarget& target,
                          RowSegments& io_segments) const;

  static constexpr size_t kCapacity = 256, kSpare = 8;
  HWY_ALIGN int32_t place_[kCapacity];  // of its first pixel in the target
  HWY_ALIGN int32_t count_[kCapacity];  // not positive: the row has no pixels
  HWY_ALIGN int32_t perspective_[kCapacity];
  HWY_ALIGN float value_[4][kCapacity], step_[4][kCapacity];  // depth, light, s, t
  HWY_ALIGN int32_t order_[kCapacity + kSpare];               // the numbers of the rows that have pixels
  size_t size_ = 0, ordered_ = 0;
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

// Copies the corners of four triangles to the list, field by field.
HWY_INLINE void ListCorners(const TriangleJob& job, const FrontTriangle* const (&from)[4], int first,
                            TriangleList& io_list) {
  const hn::FixedTag<float, 4> d4;
  const hn::FixedTag<float, 2> d2;
  static_assert(sizeof(ScreenVertex) == 16 && sizeof(TexelPoint) == 8);
  for (int corner = 0; corner < 3; ++corner) {
    const auto vertex = [&](int i) HWY_ATTR {
      return hn::LoadU(d4, reinterpret_cast<const float*>(job.vertices + from[i]->corners[corner]));
    };
    const auto texel = [&](int i) HWY_ATTR {
      return hn::ZeroExtendVector(d4, hn::LoadU(d2, &job.texels[from[i]->corners[corner]].s));
    };
    const auto v0 = vertex(0), v1 = vertex(1), v2 = vertex(2), v3 = vertex(3);
    const auto xy01 = hn::InterleaveLower(d4, v0, v1), xy23 = hn::InterleaveLower(d4, v2, v3);
    const auto dl01 = hn::InterleaveUpper(d4, v0, v1), dl23 = hn::InterleaveUpper(d4, v2, v3);
    const auto st01 = hn::InterleaveLower(d4, texel(0), texel(1));
    const auto st23 = hn::InterleaveLower(d4, texel(2), texel(3));
    hn::Store(hn::ConcatLowerLower(d4, xy23, xy01), d4, reinterpret_cast<float*>(io_list.x[corner] + first));
    hn::Store(hn::ConcatUpperUpper(d4, xy23, xy01), d4, reinterpret_cast<float*>(io_list.y[corner] + first));
    hn::Store(hn::ConcatLowerLower(d4, dl23, dl01), d4, io_list.depth[corner] + first);
    hn::Store(hn::ConcatUpperUpper(d4, dl23, dl01), d4, io_list.light[corner] + first);
    hn::Store(hn::ConcatLowerLower(d4, st23, st01), d4, io_list.s[corner] + first);
    hn::Store(hn::ConcatUpperUpper(d4, st23, st01), d4, io_list.t[corner] + first);
  }
}

// `count` is at least 1. The list's last vector is completed with copies of a triangle, without rows.
HWY_INLINE void ListTriangles(const TriangleJob& job, const FrontTriangle* const* from, int count,
                              const TriangleTarget& target, TriangleList& out) {
  out.size = count;
  for (int first = 0; first < (count + 7) / 8 * 8; first += 4) {
    const FrontTriangle* four[4];
    for (int i = 0; i < 4; ++i) {
      const int number = first + i;
      four[i] = from[HWY_MIN(number, count - 1)];
      out.row[number] = HWY_MAX(four[i]->first_row, target.row_begin);
      out.row_end[number] = number < count ? HWY_MIN(four[i]->row_end, target.row_end) : out.row[number];
    }
    ListCorners(job, four, first, out);
  }
}

HWY_INLINE Corner LoadCorner(const TriangleList& list, int corner, int first) {
  const DD d;
  const DDF df;
  const DDI di;
  return {hn::PromoteTo(d, hn::LoadU(di, list.x[corner] + first)),
          hn::PromoteTo(d, hn::LoadU(di, list.y[corner] + first)),
          hn::LoadU(df, list.depth[corner] + first),
          hn::LoadU(df, list.light[corner] + first),
          hn::LoadU(df, list.s[corner] + first),
          hn::LoadU(df, list.t[corner] + first)};
}

HWY_INLINE void SetUpSide(const Corner& from, const Corner& to, int side, Setups& out) {
  const DD d;
  const VD zero = hn::Zero(d), nowhere = hn::Set(d, 1e9);
  const VD dx = hn::Sub(to.x, from.x), dy = hn::Sub(to.y, from.y);
  const auto goes_up = hn::Lt(dy, zero), is_level = hn::Eq(dy, zero);
  const VD sign = hn::IfThenElse(goes_up, hn::Set(d, -1.0), hn::Set(d, 1.0));
  const VD scaled = hn::Mul(sign, hn::Set(d, kSubpixels));
  const VD numerator = hn::Sub(hn::Mul(from.x, dy), hn::Mul(from.y, dx));
  hn::Store(hn::IfThenZeroElse(is_level, hn::Mul(numerator, sign)), d, out.numerator[side]);
  hn::Store(hn::IfThenZeroElse(is_level, hn::Mul(dx, scaled)), d, out.step[side]);
  hn::Store(hn::IfThenElse(is_level, hn::Set(d, 1.0), hn::Mul(dy, scaled)), d, out.denominator[side]);
  // Corners are clockwise, so the triangle is to the right of a side that goes up.
  hn::Store(hn::IfThenElse(goes_up, zero, hn::Neg(nowhere)), d, out.left_bias[side]);
  hn::Store(hn::IfThenElse(hn::Gt(dy, zero), zero, nowhere), d, out.right_bias[side]);
}

// Computes the setup of as many triangles as a vector has lanes, from number `first` on.
HWY_INLINE void SetUp(const TriangleJob& job, const TriangleList& triangles, int first, Setups& io_setups) {
  const DD d;
  const DDF df;
  const Corner a = LoadCorner(triangles, 0, first);
  const Corner b = LoadCorner(triangles, 1, first);
  const Corner c = LoadCorner(triangles, 2, first);
  SetUpSide(a, b, 0, io_setups);
  SetUpSide(b, c, 1, io_setups);
  SetUpSide(c, a, 2, io_setups);

  const VD bx = hn::Sub(b.x, a.x), by = hn::Sub(b.y, a.y), cx = hn::Sub(c.x, a.x), cy = hn::Sub(c.y, a.y);
  const VD cross = hn::Sub(hn::Mul(bx, cy), hn::Mul(cx, by));
  const VD to_pixels = hn::Div(hn::Set(d, kSubpixels), cross);
  const VD x1 = hn::Mul(bx, to_pixels), y1 = hn::Mul(by, to_pixels);
  const VD x2 = hn::Mul(cx, to_pixels), y2 = hn::Mul(cy, to_pixels);
  const VD pixel = hn::Set(d, 1.0 / kSubpixels);
  hn::Store(hn::Mul(a.x, pixel), d, io_setups.corner_x);
  hn::Store(hn::Mul(a.y, pixel), d, io_setups.corner_y);

  const VDF farthest = Least(a.depth, b.depth, c.depth);
  const VDF texels = hn::Max(Range(a.s, b.s, c.s), Range(a.t, b.t, c.t));
  const VDF bend = hn::Mul(texels, Range(a.depth, b.depth, c.depth));
  const VDF most = job.perspective ? hn::Mul(hn::Set(df, 4 * kAffineErrorTexels), farthest)
                                   : hn::Set(df, hwy::HighestValue<float>());
  const auto perspective = hn::Gt(bend, most);
  hn::Store(hn::BitCast(DDI(), hn::VecFromMask(df, perspective)), DDI(), io_setups.perspective);

  const auto gradient = [&](int i, VD v0, VD v1, VD v2) HWY_ATTR {
    const VD along1 = hn::Sub(v1, v0), along2 = hn::Sub(v2, v0);
    hn::Store(v0, d, io_setups.at_corner[i]);
    hn::Store(hn::Sub(hn::Mul(along1, y2), hn::Mul(along2, y1)), d, io_setups.dx[i]);
    hn::Store(hn::Sub(hn::Mul(along2, x1), hn::Mul(along1, x2)), d, io_setups.dy[i]);
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

// Where a vector of rows takes its triangles' setups from: all from one, or each lane from its own.
struct OneTriangle {
  int number;
  HWY_INLINE VD operator()(const double* values) const { return hn::Set(DD(), values[number]); }
  HWY_INLINE hn::Vec<DDI> operator()(const int32_t* values) const { return hn::Set(DDI(), values[number]); }
};
struct EachItsOwn {
  HWY_INLINE VD operator()(const double* values) const { return hn::Load(DD(), values); }
  HWY_INLINE hn::Vec<DDI> operator()(const int32_t* values) const { return hn::Load(DDI(), values); }
};

template <typename Source>
HWY_INLINE void RowList::Store(const Setups& setups, Source of, hn::Vec<DDI> rows, hn::Vec<DDI> end,
                               const TriangleTarget& target) {
  const DD d;
  const DDF df;
  const DDI di;
  const VD y = hn::PromoteTo(d, rows);
  const VD zero = hn::Zero(d), width = hn::Set(d, static_cast<double>(target.width));
  VD left = zero, right = width;
  for (int i = 0; i < 3; ++i) {
    const VD numerator = hn::Add(of(setups.numerator[i]), hn::Mul(of(setups.step[i]), y));
    const VD column = hn::Ceil(hn::Div(numerator, of(setups.denominator[i])));
    left = hn::Max(left, hn::Add(column, of(setups.left_bias[i])));
    right = hn::Min(right, hn::Add(column, of(setups.right_bias[i])));
  }
  left = hn::Min(left, width);
  right = hn::Max(right, zero);
  const VD from_x = hn::Sub(left, of(setups.corner_x));
  const VD from_y = hn::Sub(y, of(setups.corner_y));
  const VD rows_above = hn::Sub(y, hn::Set(d, static_cast<double>(target.first_row)));
  const auto count = hn::DemoteTo(di, hn::Sub(right, left));
  hn::StoreU(hn::IfThenElseZero(hn::Lt(rows, end), count), di, count_ + size_);
  hn::StoreU(hn::DemoteTo(di, hn::Add(hn::Mul(rows_above, width), left)), di, place_ + size_);
  hn::StoreU(of(setups.perspective), di, perspective_ + size_);
  for (int i = 0; i < 4; ++i) {
    const VD dx = of(setups.dx[i]);
    const VD along = hn::Add(of(setups.at_corner[i]), hn::Mul(dx, from_x));
    const VD value = hn::Add(along, hn::Mul(of(setups.dy[i]), from_y));
    hn::StoreU(hn::DemoteTo(df, value), df, value_[i] + size_);
    hn::StoreU(hn::DemoteTo(df, dx), df, step_[i] + size_);
  }
  size_ += hn::Lanes(d);
}

HWY_INLINE void RowList::AddRows(const Setups& setups, int triangle, int row, int end,
                                 const TriangleTarget& target) {
  const DDI di;
  const auto lanes = hn::Iota(di, 0);
  const size_t first = size_;
  Store(setups, OneTriangle{triangle}, hn::Add(hn::Set(di, row), lanes), hn::Set(di, end), target);
  const auto has_pixels = hn::Gt(hn::LoadU(di, count_ + first), hn::Zero(di));
  const auto numbers = hn::Add(hn::Set(di, static_cast<int32_t>(first)), lanes);
  hn::StoreU(hn::Compress(numbers, has_pixels), di, order_ + ordered_);
  ordered_ += hn::CountTrue(di, has_pixels);
}

// The first vector has the first row of each triangle, the next one the second rows, and so on. Rows are
// drawn triangle by triangle: pixels must meet the triangles in their order, and the next triangle often
// continues a row, and would wait until the row's depth is written.
HWY_INLINE void RowList::AddTriangles(const Setups& setups, hn::Vec<DDI> row, hn::Vec<DDI> end, int most,
                                      const TriangleTarget& target) {
  const DDI di;
  const size_t lanes = hn::Lanes(di), first = size_;
  for (int i = 0; i < most; ++i) Store(setups, EachItsOwn{}, hn::Add(row, hn::Set(di, i)), end, target);
  for (size_t lane = 0; lane < lanes; ++lane)
    for (size_t number = first + lane; number < size_; number += lanes) {
      order_[ordered_] = static_cast<int32_t>(number);
      ordered_ += static_cast<size_t>(count_[number] > 0);
    }
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
HWY_NOINLINE void RowList::Draw(const TriangleJob& job, const TriangleTarget& target) {
  // The picture is larger than the first-level cache, and the next triangle may be anywhere.
  const auto prefetch = [&](size_t i) HWY_ATTR {
    hwy::Prefetch(target.depth + place_[order_[i]]);
    hwy::Prefetch(static_cast<const Pixel*>(target.pixels) + place_[order_[i]]);
  };
  for (size_t i = 0; i < HWY_MIN(kRowsAhead, ordered_); ++i) prefetch(i);
  for (size_t i = 0; i < ordered_; ++i) {
    prefetch(HWY_MIN(i + kRowsAhead, ordered_ - 1));
    const size_t row = static_cast<size_t>(order_[i]);
    if (perspective_[row] != 0)
      DrawRow<Pixel, true>(job, row, target, segments_);
    else
      DrawRow<Pixel, false>(job, row, target, segments_);
  }
  size_ = ordered_ = 0;
  segments_.Draw(job, static_cast<Pixel*>(target.pixels));
}

// Adds the rows of a vector of triangles, which have been set up, and draws the list when it is full. Vectors
// of rows take many triangles or one, whichever needs fewer vectors.
template <typename Pixel>
HWY_INLINE void ListRows(const TriangleJob& job, const TriangleTarget& target, const TriangleList& triangles,
                         int first, const Setups& setups, RowList& io_rows) {
  const DDI di;
  const int at_once = static_cast<int>(hn::Lanes(di)), count = HWY_MIN(at_once, triangles.size - first);
  const auto row = hn::LoadU(di, triangles.row + first), end = hn::LoadU(di, triangles.row_end + first);
  const int most = hn::GetLane(hn::MaxOfLanes(di, hn::Sub(end, row)));
  if (most < count) {
    io_rows.AddTriangles(setups, row, end, most, target);
    if (!io_rows.has_room()) io_rows.Draw<Pixel>(job, target);
    return;
  }
  for (int i = 0; i < count; ++i)
    for (int y = triangles.row[first + i]; y < triangles.row_end[first + i]; y += at_once) {
      io_rows.AddRows(setups, i, y, triangles.row_end[first + i], target);
      if (!io_rows.has_room()) io_rows.Draw<Pixel>(job, target);
    }
}

template <typename Pixel>
HWY_INLINE void DrawTriangles(const TriangleJob& job, const TriangleTarget& target) {
  // Triangles that touch the target's rows are collected first, branchless.
  constexpr size_t kBatch = 256;
  const FrontTriangle* here[kBatch];
  const int at_once = static_cast<int>(hn::Lanes(DD()));
  TriangleList triangles;
  Setups setups;
  RowList rows;
  for (size_t begin = 0; begin < job.front_count; begin += kBatch) {
    const size_t end = HWY_MIN(begin + kBatch, job.front_count);
    int count = 0;
    for (size_t i = begin; i < end; ++i) {
      here[count] = job.fronts + i;
      count += static_cast<int>(job.fronts[i].row_end > target.row_begin) &
               static_cast<int>(job.fronts[i].first_row < target.row_end);
    }
    for (int listed = 0; listed < count; listed += TriangleList::kCapacity) {
      ListTriangles(job, here + listed, HWY_MIN(count - listed, TriangleList::kCapacity), target, triangles);
      for (int first = 0; first < triangles.size; first += at_once) {
        SetUp(job, triangles, first, setups);
        ListRows<Pixel>(job, target, triangles, first, setups, rows);
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
