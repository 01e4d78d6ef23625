// Hot loop. The SIMD versions of lit_kernels_scalar.cpp, compiled once for each instruction set.
#include "lab/world_light/lit_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "lab/world_light/lit_kernels_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "render/spans/fetch_texels-inl.h"

HWY_BEFORE_NAMESPACE();
namespace temblor::lab::HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR

void DrawGridLitU8(const LitSpans& spans, const GridLight& light, const render::KernelTarget& target) {
  draw_grid_lit_u8_scalar(spans, light, target);
}
void DrawGridLitU32(const LitSpans& spans, const GridLight& light, const render::KernelTarget& target) {
  draw_grid_lit_u32_scalar(spans, light, target);
}
void DrawLineLitU8(const LitSpans& spans, const LineLights& light, const render::KernelTarget& target) {
  draw_line_lit_u8_scalar(spans, light, target);
}
void DrawLineLitU32(const LitSpans& spans, const LineLights& light, const render::KernelTarget& target) {
  draw_line_lit_u32_scalar(spans, light, target);
}

#else

namespace hn = hwy::HWY_NAMESPACE;
namespace rn = render::HWY_NAMESPACE;

using rn::DF;
using rn::DI;
using rn::DU;
using rn::VF;
using rn::VI;
using VU = hn::Vec<DU>;
using D16 = hn::Repartition<int16_t, DU>;

HWY_INLINE hn::Vec<D16> AsPairs(VU v) {
  return hn::BitCast(D16(), v);
}
HWY_INLINE VU AsWhole(hn::Vec<D16> v) {
  return hn::BitCast(DU(), v);
}
HWY_INLINE VU Twice(VU low) {
  return hn::Or(low, hn::ShiftLeft<16>(low));
}

// Up to a vector of pixels: their numbers in the span, distances, and texels of the tile.
struct Places {
  VF lane, z;
  VI s, t;
  int count;
};

// The light of a vector of pixels, in the low 16 bits of each lane.
template <int kChannels>
struct LightLanes {
  VU channel[kChannels];
};

// The two cells of each pixel: its own, and the one below.
struct Cells {
  VU above, below;
};

// A window of the light map: three rows, as wide as a vector. Near the eye, all pixels of a vector have their
// cells there, as with FetchWindow of render's kernels.
struct CellWindow {
  bool fits;
  ptrdiff_t first;
  VU index;

  HWY_INLINE CellWindow(int columns, rn::Direction way, VI column, VI row, int count) {
    const DI di;
    const DU du;
    constexpr int kLanes = static_cast<int>(hn::MaxLanes(DU()));
    constexpr int kLaneBits = hwy::FloorLog2(static_cast<uint32_t>(kLanes));
    int first_column = hn::GetLane(column) - (way.left ? kLanes - 1 : 0);
    int first_row = hn::GetLane(row) - (way.up ? 1 : 0);
    first_column = first_column < 0 ? 0 : first_column;
    first_row = first_row < 0 ? 0 : first_row;
    const VU in_column = hn::BitCast(du, hn::Sub(column, hn::Set(di, first_column)));
    const VU in_row = hn::BitCast(du, hn::Sub(row, hn::Set(di, first_row)));
    auto is_inside =
        hn::Lt(hn::Or(in_column, hn::ShiftLeft<kLaneBits - 1>(in_row)), hn::Set(du, uint32_t{kLanes}));
    if (count < kLanes) is_inside = hn::Or(is_inside, hn::Not(hn::FirstN(du, static_cast<size_t>(count))));
    fits = hn::AllTrue(du, is_inside);
    first = first_row * columns + first_column;
    index = hn::Or(in_column, hn::ShiftLeft<kLaneBits>(in_row));
  }
  HWY_INLINE Cells Pick(const uint32_t* cells, int columns) const {
    const DU du;
    const VU top = hn::LoadU(du, cells + first), middle = hn::LoadU(du, cells + first + columns),
             bottom = hn::LoadU(du, cells + first + 2 * columns);
    return {rn::PickOfTwo(top, middle, index), rn::PickOfTwo(middle, bottom, index)};
  }
};

template <int kLightChannels>
struct GridSampler {
  static constexpr int kChannels = kLightChannels;
  const GridLight& grid;
  rn::Direction way{};

  HWY_INLINE int BeginSpan(size_t /*number*/) { return 0; }
  HWY_INLINE void SetWay(rn::Direction way_of_span) { way = way_of_span; }
  HWY_INLINE LightLanes<kChannels> Find(const Places& places) const {
    const DI di;
    const DU du;
    const int texels = 1 << grid.texel_shift;
    const VI to_nearest = hn::Set(di, grid.is_nearest ? texels / 2 : 0);
    const VI s = hn::Add(places.s, to_nearest), t = hn::Add(places.t, to_nearest);
    const VI column = hn::ShiftRightSame(s, grid.texel_shift), row = hn::ShiftRightSame(t, grid.texel_shift);
    const VI within = hn::Set(di, grid.is_nearest ? 0 : texels - 1);
    const VU right = hn::BitCast(du, hn::ShiftLeftSame(hn::And(s, within), 15 - grid.texel_shift));
    const VU down = Twice(hn::BitCast(du, hn::ShiftLeftSame(hn::And(t, within), 15 - grid.texel_shift)));
    LightLanes<kChannels> light;
    const CellWindow window(grid.columns, way, column, row, places.count);
    if (HWY_LIKELY(window.fits)) {
      for (int i = 0; i < kChannels; ++i)
        light.channel[i] = Interpolate(window.Pick(grid.cells[i], grid.columns), right, down);
      return light;
    }
    VI position = hn::Add(hn::Mul(row, hn::Set(di, grid.columns)), column);
    if (places.count < static_cast<int>(hn::Lanes(di)))
      position = hn::IfThenElseZero(hn::FirstN(di, static_cast<size_t>(places.count)), position);
    for (int i = 0; i < kChannels; ++i) {
      const Cells cells{hn::GatherIndex(du, grid.cells[i], position),
                        hn::GatherIndex(du, grid.cells[i] + grid.columns, position)};
      light.channel[i] = Interpolate(cells, right, down);
    }
    return light;
  }

  // The same arithmetic as in build_surface.cpp and its kernels: first down, then to the right.
  static HWY_INLINE VU Interpolate(const Cells& cells, VU right, VU down) {
    const auto above = AsPairs(cells.above), below = AsPairs(cells.below);
    const VU both = AsWhole(hn::Add(above, hn::MulFixedPoint15(hn::Sub(below, above), AsPairs(down))));
    const VU first = hn::And(both, hn::Set(DU(), 0xffffu)), second = hn::ShiftRight<16>(both);
    const auto change = hn::MulFixedPoint15(hn::Sub(AsPairs(second), AsPairs(first)), AsPairs(right));
    return AsWhole(hn::Add(AsPairs(first), change));
  }
};

template <int kLightChannels, bool kIsOverZ>
struct LineSampler {
  static constexpr int kChannels = kLightChannels;
  const LineLights& lights;
  const LineLight* line = nullptr;

  HWY_INLINE int BeginSpan(size_t number) {
    line = &lights.lines[number];
    return line->pixels_before;
  }
  HWY_INLINE void SetWay(rn::Direction /*way*/) {}
  HWY_INLINE LightLanes<kChannels> Find(const Places& places) const {
    const DF d;
    LightLanes<kChannels> light;
    for (int i = 0; i < kChannels; ++i) {
      VF value = hn::Add(hn::Set(d, line->base[i]), hn::Mul(places.lane, hn::Set(d, line->step[i])));
      if constexpr (kIsOverZ) value = hn::Mul(value, places.z);
      value = hn::Min(hn::Max(value, hn::Set(d, line->least[i])), hn::Set(d, line->most[i]));
      const VI whole = rn::TruncateBiased(hn::Add(value, hn::Set(d, 0.5f)));
      light.channel[i] = hn::BitCast(DU(), hn::Sub(whole, hn::Set(DI(), rn::kBias)));
    }
    return light;
  }
};

// Looks up one texel at a time, like the kernel that builds surfaces: a gather is no faster.
template <int kChannels>
HWY_INLINE void StoreLit(VU texels, const LightLanes<kChannels>& light, const LitSpans& spans, uint8_t* out,
                         int count) {
  const DU du;
  constexpr int kLanes = static_cast<int>(hn::MaxLanes(DU()));
  HWY_ALIGN uint32_t positions[kLanes];
  hn::Store(hn::Or(hn::AndNot(hn::Set(du, 255u), light.channel[0]), texels), du, positions);
  if (HWY_LIKELY(count == kLanes)) {
    for (int i = 0; i < kLanes; ++i) out[i] = spans.colormap[positions[i]];
    return;
  }
  for (int i = 0; i < count && i < kLanes; ++i) out[i] = spans.colormap[positions[i]];
}

template <int kChannels>
HWY_INLINE void StoreLit(VU texels, const LightLanes<kChannels>& light, const LitSpans& /*spans*/,
                         uint32_t* out, int count) {
  const DU du;
  const auto lit = [&](VU colors, VU by) HWY_ATTR {
    const auto twice = AsPairs(hn::Add(colors, colors));
    return AsWhole(hn::Min(hn::MulFixedPoint15(twice, AsPairs(by)), hn::Set(D16(), 255)));
  };
  VU green, blue_red;
  if constexpr (kChannels == 3) {
    green = light.channel[1];
    blue_red = hn::Or(light.channel[0], hn::ShiftLeft<16>(light.channel[2]));
  } else {
    green = light.channel[0];
    blue_red = Twice(light.channel[0]);
  }
  const VU alpha = hn::Set(du, 0xff000000u);
  const VU shown_blue_red = lit(hn::And(texels, hn::Set(du, 0xff00ffu)), blue_red);
  const VU shown_green = lit(hn::And(hn::ShiftRight<8>(texels), hn::Set(du, 255u)), green);
  const VU shown = hn::Or(shown_blue_red, hn::ShiftLeft<8>(shown_green));
  const auto is_full_bright = hn::Eq(hn::And(texels, alpha), hn::Zero(du));
  rn::StoreTexels(hn::Or(hn::IfThenElse(is_full_bright, texels, shown), alpha), out, count);
}

// number mod size. `number` is below 2^15, so the quotient in float is exact.
struct Wrap {
  int size, first;
  HWY_INLINE VI At(VI number) const {
    const DI di;
    const VI moved = hn::Add(number, hn::Set(di, first));
    if ((size & (size - 1)) == 0) return hn::And(moved, hn::Set(di, size - 1));
    const VF share = hn::Set(DF(), 1.0f / static_cast<float>(size));
    const VF quotient = hn::Mul(hn::Add(hn::ConvertTo(DF(), moved), hn::Set(DF(), 0.5f)), share);
    const VI whole = hn::Sub(rn::TruncateBiased(quotient), hn::Set(di, rn::kBias));
    return hn::Sub(moved, hn::Mul(whole, hn::Set(di, size)));
  }
};

struct SpanLines {
  rn::Line depth, s, t;
};

// How a span crosses the texture: s / depth changes by s_change * z * z per pixel, and t likewise.
struct Walk {
  float s_change, t_change;
  HWY_INLINE explicit Walk(const SpanLines& lines, bool perspective)
      : s_change(perspective ? lines.s.step * lines.depth.base - lines.s.base * lines.depth.step
                             : lines.s.step),
        t_change(perspective ? lines.t.step * lines.depth.base - lines.t.base * lines.depth.step
                             : lines.t.step) {}
  HWY_INLINE rn::Direction Way() const { return {s_change < 0, t_change < 0}; }
  // Whether a vector of pixels probably needs no more than four rows and a texel per pixel at the span's far
  // end, where texels are densest.
  HWY_INLINE bool IsNear(const SpanLines& lines, bool perspective, int count) const {
    float least = 1.0f;
    if (perspective) {
      const float last = lines.depth.base + static_cast<float>(count - 1) * lines.depth.step;
      least = last < lines.depth.base ? last : lines.depth.base;
      if (!(least > render::kMinSpanDepth)) return false;
    }
    const float square = least * least;
    const float columns = s_change < 0 ? -s_change : s_change;
    const float rows = (t_change < 0 ? -t_change : t_change) * (static_cast<float>(hn::Lanes(DF())) - 1.0f);
    return columns <= square && rows <= 3.0f * square;
  }
};

// Draws one span, a vector of pixels at a time.
template <typename Texel, bool kNear, class Sampler>
struct SpanDrawer {
  const LitSpans& spans;
  const Sampler& sampler;
  const SpanLines& lines;
  rn::Direction way;
  int before;  // pixels of the span, see LineLight
  Texel* out;
  float* out_depth;

  static HWY_INLINE VF At(const rn::Line& line, VF lane) {
    return hn::Add(hn::Set(DF(), line.base), hn::Mul(lane, hn::Set(DF(), line.step)));
  }
  static HWY_INLINE VI Clamp(VF texel, int last) {
    const VF bound = hn::Set(DF(), static_cast<float>(last));
    return hn::Sub(rn::TruncateBiased(hn::Min(hn::Max(texel, hn::Zero(DF())), bound)),
                   hn::Set(DI(), rn::kBias));
  }

  HWY_INLINE void DrawVector(int i, int count) const {
    const DF d;
    Places places;
    places.count = count;
    places.lane = hn::Iota(d, static_cast<float>(before + i));
    const VF depth = At(lines.depth, places.lane);
    if (out_depth != nullptr) {
      if (count == static_cast<int>(hn::Lanes(d)))
        hn::StoreU(depth, d, out_depth + i);
      else
        rn::StoreFirst(d, depth, out_depth + i, count);
    }
    places.z = hn::Set(d, 1.0f);
    if (spans.perspective) places.z = hn::Div(places.z, hn::Max(depth, hn::Set(d, render::kMinSpanDepth)));
    places.s = Clamp(hn::Mul(At(lines.s, places.lane), places.z), spans.last_s);
    places.t = Clamp(hn::Mul(At(lines.t, places.lane), places.z), spans.last_t);
    const TileTexture& texture = spans.texture;
    const VI bias = hn::Set(DI(), rn::kBias);
    const rn::TexelLanes at{hn::Add(Wrap{texture.width, spans.first_s}.At(places.s), bias),
                            hn::Add(Wrap{texture.height, spans.first_t}.At(places.t), bias)};
    HWY_ALIGN Texel fetched[rn::kMaxLanes];
    rn::Fetch<kNear ? 4 : 0>(static_cast<const Texel*>(texture.texels),
                             rn::Rows{texture.width, texture.height - 1}, way, at, fetched, count);
    StoreLit(rn::LoadTexels(fetched), sampler.Find(places), spans, out + i, count);
  }

  HWY_INLINE void Draw(int count) const {
    constexpr int kLanes = static_cast<int>(hn::MaxLanes(DF()));
    int i = 0;
    for (; i + kLanes <= count; i += kLanes) DrawVector(i, kLanes);
    if (i == count) return;
#if HWY_TARGET > HWY_AVX3  // storing a part of a vector is slower than drawing some pixels twice
    if (count > kLanes) {
      DrawVector(count - kLanes, kLanes);
      return;
    }
#endif
    DrawVector(i, count - i);
  }
};

template <typename Texel, class Sampler>
HWY_INLINE void DrawLit(const LitSpans& spans, Sampler sampler, const render::KernelTarget& target) {
  SpanLines lines;
  lines.depth.step = static_cast<float>(spans.depth.dx);
  lines.s.step = static_cast<float>(spans.s.dx);
  lines.t.step = static_cast<float>(spans.t.dx);
  for (size_t number = 0; number < spans.span_count; ++number) {
    const render::Span& span = spans.spans[number];
    const size_t first = span.y * target.width + span.x;
    Texel* out = static_cast<Texel*>(target.pixels) + first;
    float* out_depth = target.depth == nullptr ? nullptr : target.depth + first;
    const int before = sampler.BeginSpan(number);
    const render::Span whole{static_cast<uint16_t>(span.x - before), span.y, 0};
    lines.depth.base = rn::At(spans.depth, whole);
    lines.s.base = rn::At(spans.s, whole);
    lines.t.base = rn::At(spans.t, whole);
    const Walk walk(lines, spans.perspective);
    sampler.SetWay(walk.Way());
    if (walk.IsNear(lines, spans.perspective, before + span.count))
      SpanDrawer<Texel, true, Sampler>{spans, sampler, lines, walk.Way(), before, out, out_depth}.Draw(
          span.count);
    else
      SpanDrawer<Texel, false, Sampler>{spans, sampler, lines, walk.Way(), before, out, out_depth}.Draw(
          span.count);
  }
}

void DrawGridLitU8(const LitSpans& spans, const GridLight& light, const render::KernelTarget& target) {
  DrawLit<uint8_t>(spans, GridSampler<1>{light}, target);
}
void DrawGridLitU32(const LitSpans& spans, const GridLight& light, const render::KernelTarget& target) {
  if (light.channels == 3)
    DrawLit<uint32_t>(spans, GridSampler<3>{light}, target);
  else
    DrawLit<uint32_t>(spans, GridSampler<1>{light}, target);
}

template <typename Texel, int kChannels>
HWY_INLINE void DrawLineLit(const LitSpans& spans, const LineLights& light,
                            const render::KernelTarget& target) {
  if (light.is_over_z)
    DrawLit<Texel>(spans, LineSampler<kChannels, true>{light}, target);
  else
    DrawLit<Texel>(spans, LineSampler<kChannels, false>{light}, target);
}
void DrawLineLitU8(const LitSpans& spans, const LineLights& light, const render::KernelTarget& target) {
  DrawLineLit<uint8_t, 1>(spans, light, target);
}
void DrawLineLitU32(const LitSpans& spans, const LineLights& light, const render::KernelTarget& target) {
  if (light.channels == 3)
    DrawLineLit<uint32_t, 3>(spans, light, target);
  else
    DrawLineLit<uint32_t, 1>(spans, light, target);
}

#endif

}  // namespace temblor::lab::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace temblor::lab {

HWY_EXPORT(DrawGridLitU8);
HWY_EXPORT(DrawGridLitU32);
HWY_EXPORT(DrawLineLitU8);
HWY_EXPORT(DrawLineLitU32);

void draw_grid_lit_u8_simd(const LitSpans& spans, const GridLight& light,
                           const render::KernelTarget& target) {
  HWY_DYNAMIC_DISPATCH(DrawGridLitU8)(spans, light, target);
}
void draw_grid_lit_u32_simd(const LitSpans& spans, const GridLight& light,
                            const render::KernelTarget& target) {
  HWY_DYNAMIC_DISPATCH(DrawGridLitU32)(spans, light, target);
}
void draw_line_lit_u8_simd(const LitSpans& spans, const LineLights& light,
                           const render::KernelTarget& target) {
  HWY_DYNAMIC_DISPATCH(DrawLineLitU8)(spans, light, target);
}
void draw_line_lit_u32_simd(const LitSpans& spans, const LineLights& light,
                            const render::KernelTarget& target) {
  HWY_DYNAMIC_DISPATCH(DrawLineLitU32)(spans, light, target);
}

}  // namespace temblor::lab
#endif
