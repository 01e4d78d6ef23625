// Hot loop. The SIMD version of vertex_kernels_scalar.cpp, compiled once for each instruction set.
#include "render/alias/vertex_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/alias/vertex_kernels_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace temblor::render::HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR

void ProjectVertices(const VertexJob& job) {
  project_vertices_scalar(job);
}
void ProjectWideVertices(const WideVertexJob& job) {
  project_vertices_scalar(job);
}

#else

namespace hn = hwy::HWY_NAMESPACE;

using DF = hn::CappedTag<float, 16>;
using DI = hn::Rebind<int32_t, DF>;
using VF = hn::Vec<DF>;
using VI = hn::Vec<DI>;

template <typename Element>
HWY_INLINE VI LoadElements(const Element* elements) {
  return hn::PromoteTo(DI(), hn::LoadU(hn::Rebind<Element, DF>(), elements));
}

HWY_INLINE VF Blend(VF from, VF to, VF blend) {
  return hn::Add(from, hn::Mul(hn::Sub(to, from), blend));
}

template <typename Element>
HWY_INLINE VF BlendElements(const Element* from, const Element* to, VF blend) {
  return Blend(hn::ConvertTo(DF(), LoadElements(from)), hn::ConvertTo(DF(), LoadElements(to)), blend);
}

HWY_INLINE VF ToView(const float* row, VF x, VF y, VF z) {
  const DF d;
  const VF xy = hn::Add(hn::Mul(hn::Set(d, row[0]), x), hn::Mul(hn::Set(d, row[1]), y));
  return hn::Add(hn::Add(xy, hn::Mul(hn::Set(d, row[2]), z)), hn::Set(d, row[3]));
}

HWY_INLINE VI ToSubpixels(VF pixels, int32_t steps_per_pixel) {
  const VF guard = hn::Set(DF(), kGuardPixels);
  const VF inside = hn::Min(hn::Max(pixels, hn::Neg(guard)), guard);
  const VI steps = hn::NearestInt(hn::Mul(inside, hn::Set(DF(), static_cast<float>(steps_per_pixel))));
  return hn::Mul(steps, hn::Set(DI(), kSubpixels / steps_per_pixel));
}

template <typename Element>
HWY_INLINE void Project(const PoseJob<Element>& job) {
  const DF d;
  const VF blend = hn::Set(d, job.blend);
  const VF pixels_per_unit = hn::Set(d, job.pixels_per_unit);
  for (size_t i = 0; i < job.count; i += hn::Lanes(d)) {
    const VF x = BlendElements(job.from[0] + i, job.to[0] + i, blend);
    const VF y = BlendElements(job.from[1] + i, job.to[1] + i, blend);
    const VF z = BlendElements(job.from[2] + i, job.to[2] + i, blend);
    const VF right = ToView(job.to_view[0], x, y, z), up = ToView(job.to_view[1], x, y, z);
    const VF forward = ToView(job.to_view[2], x, y, z);
    if (job.view[0] != nullptr) hn::StoreU(right, d, job.view[0] + i);
    if (job.view[1] != nullptr) hn::StoreU(up, d, job.view[1] + i);
    if (job.view[2] != nullptr) hn::StoreU(forward, d, job.view[2] + i);

    VF scale = pixels_per_unit, depth = hn::Neg(forward);
    if (job.perspective) {
      const VF nearness = hn::Div(hn::Set(d, 1.0f), hn::Max(forward, hn::Set(d, job.near_z)));
      scale = hn::Mul(pixels_per_unit, nearness);
      depth = hn::Mul(nearness, hn::Set(d, job.depth_scale));
    }
    const VI screen_x =
        ToSubpixels(hn::Add(hn::Set(d, job.center_x), hn::Mul(right, scale)), job.steps_per_pixel);
    const VI screen_y =
        ToSubpixels(hn::Sub(hn::Set(d, job.center_y), hn::Mul(up, scale)), job.steps_per_pixel);
    const VF light = Blend(hn::GatherIndex(d, job.lights, LoadElements(job.from[3] + i)),
                           hn::GatherIndex(d, job.lights, LoadElements(job.to[3] + i)), blend);
    hn::StoreInterleaved4(hn::BitCast(d, screen_x), hn::BitCast(d, screen_y), depth, light, d,
                          reinterpret_cast<float*>(job.out + i));
  }
}

void ProjectVertices(const VertexJob& job) {
  Project(job);
}
void ProjectWideVertices(const WideVertexJob& job) {
  Project(job);
}

#endif

}  // namespace temblor::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace temblor::render {

HWY_EXPORT(ProjectVertices);
HWY_EXPORT(ProjectWideVertices);

void project_vertices_simd(const VertexJob& job) {
  HWY_DYNAMIC_DISPATCH(ProjectVertices)(job);
}

void project_vertices_simd(const WideVertexJob& job) {
  HWY_DYNAMIC_DISPATCH(ProjectWideVertices)(job);
}

}  // namespace temblor::render
#endif
