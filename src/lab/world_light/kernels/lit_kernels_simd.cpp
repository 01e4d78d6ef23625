// Hot loop. The SIMD versions of lit_kernels_scalar.cpp, compiled once for each instruction set.
#include "lab/world_light/kernels/lit_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "lab/world_light/kernels/lit_kernels_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "lab/world_light/kernels/lit_spans-inl.h"

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
void DrawPixelLitU8(const LitSpans& spans, const PixelLights& light, const render::KernelTarget& target) {
  draw_pixel_lit_u8_scalar(spans, light, target);
}
void DrawPixelLitU32(const LitSpans& spans, const PixelLights& light, const render::KernelTarget& target) {
  draw_pixel_lit_u32_scalar(spans, light, target);
}

#else

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

template <int kLightChannels>
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
      if (lights.is_over_z) value = hn::Mul(value, places.z);
      value = hn::Min(hn::Max(value, hn::Set(d, line->least[i])), hn::Set(d, line->most[i]));
      const VI whole = rn::TruncateBiased(hn::Add(value, hn::Set(d, 0.5f)));
      light.channel[i] = hn::BitCast(DU(), hn::Sub(whole, hn::Set(DI(), rn::kBias)));
    }
    return light;
  }
};

struct PixelSampler {
  static constexpr int kChannels = 1;
  const PixelLights& lights;

  HWY_INLINE int BeginSpan(size_t /*number*/) { return lights.pixels_before; }
  HWY_INLINE void SetWay(rn::Direction /*way*/) {}
  HWY_INLINE LightLanes<1> Find(const Places& places) const {
    const int first = static_cast<int>(hn::GetLane(places.lane)) - lights.pixels_before;
    return {{hn::LoadU(DU(), lights.light + first)}};
  }
};

void DrawGridLitU8(const LitSpans& spans, const GridLight& light, const render::KernelTarget& target) {
  DrawLit<uint8_t>(spans, GridSampler<1>{light}, target);
}
void DrawGridLitU32(const LitSpans& spans, const GridLight& light, const render::KernelTarget& target) {
  if (light.channels == 3)
    DrawLit<uint32_t>(spans, GridSampler<3>{light}, target);
  else
    DrawLit<uint32_t>(spans, GridSampler<1>{light}, target);
}

void DrawLineLitU8(const LitSpans& spans, const LineLights& light, const render::KernelTarget& target) {
  DrawLit<uint8_t>(spans, LineSampler<1>{light}, target);
}
void DrawLineLitU32(const LitSpans& spans, const LineLights& light, const render::KernelTarget& target) {
  if (light.channels == 3)
    DrawLit<uint32_t>(spans, LineSampler<3>{light}, target);
  else
    DrawLit<uint32_t>(spans, LineSampler<1>{light}, target);
}
void DrawPixelLitU8(const LitSpans& spans, const PixelLights& light, const render::KernelTarget& target) {
  DrawLit<uint8_t>(spans, PixelSampler{light}, target);
}
void DrawPixelLitU32(const LitSpans& spans, const PixelLights& light, const render::KernelTarget& target) {
  DrawLit<uint32_t>(spans, PixelSampler{light}, target);
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
HWY_EXPORT(DrawPixelLitU8);
HWY_EXPORT(DrawPixelLitU32);

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
void draw_pixel_lit_u8_simd(const LitSpans& spans, const PixelLights& light,
                            const render::KernelTarget& target) {
  HWY_DYNAMIC_DISPATCH(DrawPixelLitU8)(spans, light, target);
}
void draw_pixel_lit_u32_simd(const LitSpans& spans, const PixelLights& light,
                             const render::KernelTarget& target) {
  HWY_DYNAMIC_DISPATCH(DrawPixelLitU32)(spans, light, target);
}

}  // namespace temblor::lab
#endif
