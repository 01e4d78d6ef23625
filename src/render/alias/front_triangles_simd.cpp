// Hot loop: removes back faces and triangles that cover no pixel center, once for all bands of a picture. The
// SIMD version of front_triangles_scalar.cpp, compiled once for each instruction set. Lanes are triangles.
#include "render/alias/triangle_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/alias/front_triangles_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace temblor::render::HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR

void FindFrontTriangles(const TriangleJob& job, FrontTriangles& io_fronts) {
  find_front_triangles_scalar(job, io_fronts);
}

#else

namespace hn = hwy::HWY_NAMESPACE;

constexpr size_t kAtOnce = 4;
using DI = hn::FixedTag<int32_t, kAtOnce>;
using DL = hn::FixedTag<int64_t, kAtOnce / 2>;
using VI = hn::Vec<DI>;

struct Points {
  VI x, y;
};

// One corner of four triangles.
HWY_INLINE Points LoadPoints(const ScreenVertex* vertices, const uint32_t* const (&corners)[kAtOnce],
                             int corner) {
  const DI d;
  const auto vertex = [&](int i) HWY_ATTR { return hn::LoadU(d, &vertices[corners[i][corner]].x); };
  const VI xy01 = hn::InterleaveLower(d, vertex(0), vertex(1));
  const VI xy23 = hn::InterleaveLower(d, vertex(2), vertex(3));
  return {hn::ConcatLowerLower(d, xy23, xy01), hn::ConcatUpperUpper(d, xy23, xy01)};
}

HWY_INLINE VI FirstPixel(VI steps) {
  static_assert(kSubpixels == 1 << 8);
  return hn::ShiftRight<8>(hn::Add(steps, hn::Set(DI(), kSubpixels - 1)));
}
HWY_INLINE VI Least(VI a, VI b, VI c) {
  return hn::Min(hn::Min(a, b), c);
}
HWY_INLINE VI Most(VI a, VI b, VI c) {
  return hn::Max(hn::Max(a, b), c);
}
// 32767 is larger than any picture.
HWY_INLINE VI ToRow(VI row) {
  return hn::Min(hn::Max(row, hn::Zero(DI())), hn::Set(DI(), 32767));
}

// Whether a * b > c * d in the even lanes, as all bits of 64.
HWY_INLINE VI IsMoreInEvenLanes(VI a, VI b, VI c, VI d) {
  const auto more = hn::Gt(hn::Sub(hn::MulEven(a, b), hn::MulEven(c, d)), hn::Zero(DL()));
  return hn::BitCast(DI(), hn::VecFromMask(DL(), more));
}

HWY_INLINE VI FacesFront(const Points& a, const Points& b, const Points& c) {
  const VI bx = hn::Sub(b.x, a.x), by = hn::Sub(b.y, a.y), cx = hn::Sub(c.x, a.x), cy = hn::Sub(c.y, a.y);
  const VI even = IsMoreInEvenLanes(bx, cy, cx, by);
  const VI odd =
      IsMoreInEvenLanes(hn::Shuffle2301(bx), hn::Shuffle2301(cy), hn::Shuffle2301(cx), hn::Shuffle2301(by));
  return hn::OddEven(odd, even);
}

// Branchless, because it is unpredictable which way a triangle faces.
void FindFrontTriangles(const TriangleJob& job, FrontTriangles& io_fronts) {
  const DI d;
  size_t count = 0;
  for (size_t first = 0; first < job.triangle_count; first += kAtOnce) {
    const size_t rest = HWY_MIN(kAtOnce, job.triangle_count - first);
    const uint32_t* corners[kAtOnce];
    for (size_t i = 0; i < kAtOnce; ++i) corners[i] = job.triangles + (first + HWY_MIN(i, rest - 1)) * 3;
    const Points a = LoadPoints(job.vertices, corners, 0);
    const Points b = LoadPoints(job.vertices, corners, 1);
    const Points c = LoadPoints(job.vertices, corners, 2);
    const VI top = ToRow(FirstPixel(Least(a.y, b.y, c.y))), bottom = ToRow(FirstPixel(Most(a.y, b.y, c.y)));
    const auto has_columns = hn::Lt(FirstPixel(Least(a.x, b.x, c.x)), FirstPixel(Most(a.x, b.x, c.x)));
    const auto is_front = hn::And(hn::MaskFromVec(FacesFront(a, b, c)), hn::FirstN(d, rest));
    const auto is_kept = hn::And(hn::And(has_columns, hn::Lt(top, bottom)), is_front);
    const VI numbers = hn::Add(hn::Iota(d, 0), hn::Set(d, static_cast<int32_t>(first)));
    const VI rows = hn::Or(top, hn::ShiftLeft<16>(bottom));  // as TriangleRows
    hn::StoreU(hn::Compress(numbers, is_kept), d, reinterpret_cast<int32_t*>(io_fronts.numbers + count));
    hn::StoreU(hn::Compress(rows, is_kept), d, reinterpret_cast<int32_t*>(io_fronts.rows + count));
    count += hn::CountTrue(d, is_kept);
  }
  io_fronts.count = count;
}

#endif

}  // namespace temblor::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace temblor::render {

HWY_EXPORT(FindFrontTriangles);

void find_front_triangles_simd(const TriangleJob& job, FrontTriangles& io_fronts) {
  HWY_DYNAMIC_DISPATCH(FindFrontTriangles)(job, io_fronts);
}

}  // namespace temblor::render
#endif
