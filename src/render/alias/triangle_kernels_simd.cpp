// Hot loop. The SIMD version of triangle_kernels_scalar.cpp, compiled once for each instruction set. Its
// phases, in which a vector's lanes are different things:
//
//   FindTouching    lanes are triangles   those that touch the target's rows
//   ListTriangles   lanes are triangles   corners, field by field
//   SetUp           lanes are triangles   gradients and sides
//   AddTriangles    lanes are triangles   a row of each: first pixel, length, and start values
//   AddRows         lanes are rows        the same, for the rows of one taller triangle
//   (rows/row_kernels_simd.cpp)           draws the list of rows
//
// Each phase fills a list that the next one consumes, so that the unpredictable branches of one phase do not
// wait for the divisions of another.
#include "render/alias/rows/row_list.h"
#include "render/alias/triangle_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/alias/triangle_kernels_simd.cpp"
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

using DI = hn::CappedTag<int32_t, 8>;
using VI = hn::Vec<DI>;
// Vectors of triangles or rows, as in row_kernels_simd.cpp.
using DD = hn::CappedTag<double, 8>;
using DDF = hn::Rebind<float, DD>;
using DDI = hn::Rebind<int32_t, DD>;
using VD = hn::Vec<DD>;
using VDF = hn::Vec<DDF>;

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
HWY_INLINE void ListCorners(const TriangleJob& job, const uint32_t* const (&from)[4], int first,
                            TriangleList& io_list) {
  const hn::FixedTag<float, 4> d4;
  const hn::FixedTag<float, 2> d2;
  static_assert(sizeof(ScreenVertex) == 16 && sizeof(TexelPoint) == 8);
  for (int corner = 0; corner < 3; ++corner) {
    const auto vertex = [&](int i) HWY_ATTR {
      return hn::LoadU(d4, reinterpret_cast<const float*>(job.vertices + from[i][corner]));
    };
    const auto texel = [&](int i) HWY_ATTR {
      return hn::ZeroExtendVector(d4, hn::LoadU(d2, &job.texels[from[i][corner]].s));
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

// The triangles of a batch that touch the target's rows.
struct TouchingTriangles {
  static constexpr int kCapacity = 256, kSpare = TriangleList::kCapacity;

  HWY_ALIGN uint32_t numbers[kCapacity + kSpare];
  HWY_ALIGN int32_t row[kCapacity + kSpare], row_end[kCapacity + kSpare];  // inside the target
  int size;
};

// Finds them among front triangles `begin` to `end` (exclusive), at most kCapacity. The last one is repeated,
// without rows, to complete a vector.
HWY_INLINE void FindTouching(const FrontTriangles& fronts, size_t begin, size_t end,
                             const TriangleTarget& target, TouchingTriangles& out) {
  const DI d;
  const VI row_begin = hn::Set(d, target.row_begin), row_end = hn::Set(d, target.row_end);
  size_t size = 0;
  for (size_t i = begin; i < end; i += hn::Lanes(d)) {
    const VI rows = hn::LoadU(d, reinterpret_cast<const int32_t*>(fronts.rows + i));
    const VI first = hn::Max(hn::And(rows, hn::Set(d, 0xffff)), row_begin);
    const VI last = hn::Min(hn::ShiftRight<16>(rows), row_end);
    const auto touches = hn::And(hn::Lt(first, last), hn::FirstN(d, end - i));
    hn::StoreU(hn::Compress(hn::LoadU(d, reinterpret_cast<const int32_t*>(fronts.numbers + i)), touches), d,
               reinterpret_cast<int32_t*>(out.numbers + size));
    hn::StoreU(hn::Compress(first, touches), d, out.row + size);
    hn::StoreU(hn::Compress(last, touches), d, out.row_end + size);
    size += hn::CountTrue(d, touches);
  }
  out.size = static_cast<int>(size);
  if (size == 0) return;
  for (size_t i = 0; i < 8; ++i) {
    out.numbers[size + i] = out.numbers[size - 1];
    out.row[size + i] = out.row_end[size + i] = out.row[size - 1];
  }
}

// `count` is at least 1. The list's last vector is completed with copies of a triangle, without rows.
HWY_INLINE void ListTriangles(const TriangleJob& job, const TouchingTriangles& from, int begin, int count,
                              TriangleList& out) {
  const DDI d;
  out.size = count;
  const int end = (count + 7) / 8 * 8;
  for (int first = 0; first < end; first += 4) {
    const uint32_t* four[4];
    for (int i = 0; i < 4; ++i) four[i] = job.triangles + size_t{from.numbers[begin + first + i]} * 3;
    ListCorners(job, four, first, out);
  }
  for (int first = 0; first < end; first += static_cast<int>(hn::Lanes(d))) {
    hn::StoreU(hn::LoadU(d, from.row + begin + first), d, out.row + first);
    hn::StoreU(hn::LoadU(d, from.row_end + begin + first), d, out.row_end + first);
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
  const float limit = job.always_perspective ? -1.0f : 4 * kAffineErrorTexels;
  const VDF most =
      job.perspective ? hn::Mul(hn::Set(df, limit), farthest) : hn::Set(df, hwy::HighestValue<float>());
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
HWY_INLINE void StoreRows(const Setups& setups, Source of, hn::Vec<DDI> rows, hn::Vec<DDI> end,
                          const TriangleTarget& target, RowList& io_list) {
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
  hn::StoreU(hn::IfThenElseZero(hn::Lt(rows, end), count), di, io_list.count + io_list.size);
  hn::StoreU(hn::DemoteTo(di, hn::Add(hn::Mul(rows_above, width), left)), di, io_list.place + io_list.size);
  hn::StoreU(of(setups.perspective), di, io_list.perspective + io_list.size);
  for (int i = 0; i < 4; ++i) {
    const VD dx = of(setups.dx[i]);
    const VD along = hn::Add(of(setups.at_corner[i]), hn::Mul(dx, from_x));
    const VD value = hn::Add(along, hn::Mul(of(setups.dy[i]), from_y));
    hn::StoreU(hn::DemoteTo(df, value), df, io_list.value[i] + io_list.size);
    hn::StoreU(hn::DemoteTo(df, dx), df, io_list.step[i] + io_list.size);
  }
  io_list.size += hn::Lanes(d);
}

// Whether the next group might not fit.
HWY_INLINE bool IsFull(const RowList& list) {
  return list.size > RowList::kCapacity - RowList::kMaxGroupRows;
}

HWY_INLINE void EndGroup(RowList& io_list) {
  io_list.group_end[io_list.groups++] = static_cast<int32_t>(io_list.size);
}

// Adds the rows from `row` up to `end`, at most a vector of them, of one triangle.
template <bool kShortRows>
HWY_INLINE void AddRows(const Setups& setups, int triangle, int row, int end, const TriangleTarget& target,
                        RowList& io_list) {
  const DDI di;
  const auto lanes = hn::Iota(di, 0);
  const size_t first = io_list.size;
  StoreRows(setups, OneTriangle{triangle}, hn::Add(hn::Set(di, row), lanes), hn::Set(di, end), target,
            io_list);
  if constexpr (kShortRows) return EndGroup(io_list);
  const auto has_pixels = hn::Gt(hn::LoadU(di, io_list.count + first), hn::Zero(di));
  const auto numbers = hn::Add(hn::Set(di, static_cast<int32_t>(first)), lanes);
  hn::StoreU(hn::Compress(numbers, has_pixels), di, io_list.order + io_list.ordered);
  io_list.ordered += hn::CountTrue(di, has_pixels);
}

// Adds all rows, from `row` up to `end`, of a vector of triangles. None has more than `most` rows. The first
// vector has the first row of each triangle, the next one the second rows, and so on. Rows are drawn triangle
// by triangle, also because the next triangle often continues a row, and would wait until the row's depth is
// written.
template <bool kShortRows>
HWY_INLINE void AddTriangles(const Setups& setups, hn::Vec<DDI> row, hn::Vec<DDI> end, int most,
                             const TriangleTarget& target, RowList& io_list) {
  const DDI di;
  const size_t lanes = hn::Lanes(di), first = io_list.size;
  for (int i = 0; i < most; ++i)
    StoreRows(setups, EachItsOwn{}, hn::Add(row, hn::Set(di, i)), end, target, io_list);
  if constexpr (kShortRows) return EndGroup(io_list);
  for (size_t lane = 0; lane < lanes; ++lane)
    for (size_t number = first + lane; number < io_list.size; number += lanes) {
      io_list.order[io_list.ordered] = static_cast<int32_t>(number);
      io_list.ordered += static_cast<size_t>(io_list.count[number] > 0);
    }
}

HWY_INLINE void Clear(RowList& out) {
  out.size = out.ordered = out.groups = 0;
}

HWY_INLINE void DrawList(const TriangleJob& job, const TriangleTarget& target, uint8_t, RowList& io_list) {
  draw_rows_u8_simd(job, io_list, target);
  Clear(io_list);
}
HWY_INLINE void DrawList(const TriangleJob& job, const TriangleTarget& target, uint32_t, RowList& io_list) {
  draw_rows_u32_simd(job, io_list, target);
  Clear(io_list);
}

// Adds the rows of a vector of triangles, which have been set up, and draws the list when it is full. Vectors
// of rows take many triangles or one, whichever needs fewer vectors.
template <typename Pixel, bool kShortRows>
HWY_INLINE void ListRows(const TriangleJob& job, const TriangleTarget& target, const TriangleList& triangles,
                         int first, const Setups& setups, RowList& io_list) {
  const DDI di;
  const int at_once = static_cast<int>(hn::Lanes(di)), count = HWY_MIN(at_once, triangles.size - first);
  const auto row = hn::LoadU(di, triangles.row + first), end = hn::LoadU(di, triangles.row_end + first);
  const int most = hn::GetLane(hn::MaxOfLanes(di, hn::Sub(end, row)));
  if (most < count) {
    AddTriangles<kShortRows>(setups, row, end, most, target, io_list);
    if (IsFull(io_list)) DrawList(job, target, Pixel{}, io_list);
    return;
  }
  for (int i = 0; i < count; ++i)
    for (int y = triangles.row[first + i]; y < triangles.row_end[first + i]; y += at_once) {
      AddRows<kShortRows>(setups, i, y, triangles.row_end[first + i], target, io_list);
      if (IsFull(io_list)) DrawList(job, target, Pixel{}, io_list);
    }
}

template <typename Pixel, bool kShortRows>
HWY_INLINE void DrawTriangles(const TriangleJob& job, const TriangleTarget& target) {
  const int at_once = static_cast<int>(hn::Lanes(DD()));
  TouchingTriangles touching;
  TriangleList triangles;
  Setups setups;
  RowList rows;
  Clear(rows);
  for (size_t begin = 0; begin < job.fronts.count; begin += TouchingTriangles::kCapacity) {
    FindTouching(job.fronts, begin, HWY_MIN(begin + TouchingTriangles::kCapacity, job.fronts.count), target,
                 touching);
    for (int listed = 0; listed < touching.size; listed += TriangleList::kCapacity) {
      ListTriangles(job, touching, listed, HWY_MIN(touching.size - listed, TriangleList::kCapacity),
                    triangles);
      for (int first = 0; first < triangles.size; first += at_once) {
        SetUp(job, triangles, first, setups);
        ListRows<Pixel, kShortRows>(job, target, triangles, first, setups, rows);
      }
    }
  }
  DrawList(job, target, Pixel{}, rows);
}

void DrawTrianglesU8(const TriangleJob& job, const TriangleTarget& target) {
  job.has_short_rows ? DrawTriangles<uint8_t, true>(job, target) : DrawTriangles<uint8_t, false>(job, target);
}
void DrawTrianglesU32(const TriangleJob& job, const TriangleTarget& target) {
  job.has_short_rows ? DrawTriangles<uint32_t, true>(job, target)
                     : DrawTriangles<uint32_t, false>(job, target);
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
