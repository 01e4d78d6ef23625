// Hot loop. The SIMD versions of particle_kernels_scalar.cpp, compiled once for each instruction set.
#include "render/particles/particle_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/particles/particle_kernels_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace temblor::render::HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR

void ProjectParticles(const ParticleProjection& projection, const ParticleBatch& batch) {
  project_particles_scalar(projection, batch);
}
void DrawParticlesU8(const ParticleRect* rects, size_t count, const ParticleTarget& target) {
  draw_particles_u8_scalar(rects, count, target);
}
void DrawParticlesU32(const ParticleRect* rects, size_t count, const ParticleTarget& target) {
  draw_particles_u32_scalar(rects, count, target);
}

#else

namespace hn = hwy::HWY_NAMESPACE;

using DF = hn::CappedTag<float, 16>;
using DI = hn::Rebind<int32_t, DF>;
using DU = hn::RebindToUnsigned<DI>;
using D8 = hn::Rebind<uint8_t, DU>;
using VF = hn::Vec<DF>;

HWY_INLINE VF Along(const float (&axis)[3], VF x, VF y, VF z) {
  const DF d;
  return hn::Add(hn::Add(hn::Mul(x, hn::Set(d, axis[0])), hn::Mul(y, hn::Set(d, axis[1]))),
                 hn::Mul(z, hn::Set(d, axis[2])));
}

// Projects a vector of particles, from number `first` on. Comparisons and rounding as in the scalar
// reference.
template <bool kPerspective>
HWY_INLINE void ProjectVector(const ParticleProjection& p, const ParticleBatch& batch, size_t first) {
  const DF d;
  const DI di;
  const VF dx = hn::Sub(hn::LoadU(d, batch.x + first), hn::Set(d, p.eye[0]));
  const VF dy = hn::Sub(hn::LoadU(d, batch.y + first), hn::Set(d, p.eye[1]));
  const VF dz = hn::Sub(hn::LoadU(d, batch.z + first), hn::Set(d, p.eye[2]));
  const VF distance = Along(p.forward, dx, dy, dz);
  const VF nearness = kPerspective ? hn::Div(hn::Set(d, 1.0f), distance) : hn::Set(d, 1.0f);
  const VF scale = hn::Mul(hn::Set(d, p.pixels_per_unit), nearness);
  const VF center_x = hn::Add(hn::Set(d, p.center_x), hn::Mul(Along(p.right, dx, dy, dz), scale));
  const VF center_y = hn::Sub(hn::Set(d, p.center_y), hn::Mul(Along(p.up, dx, dy, dz), scale));
  const VF raw_side = hn::Mul(hn::Set(d, p.side_at_one_unit), nearness);
  const VF bounded_side = hn::Min(hn::Max(raw_side, hn::Set(d, p.min_side)), hn::Set(d, p.max_side));
  const VF side = hn::Floor(hn::Add(bounded_side, hn::Set(d, 0.5f)));
  const VF half = hn::Mul(side, hn::Set(d, 0.5f));
  const VF left = hn::Ceil(hn::Sub(center_x, half)), top = hn::Ceil(hn::Sub(center_y, half));
  const VF outside = hn::Neg(side);
  const auto in_columns = hn::And(hn::Gt(left, outside), hn::Lt(left, hn::Set(d, p.width)));
  const auto in_rows = hn::And(hn::Gt(top, outside), hn::Lt(top, hn::Set(d, p.height)));
  const auto in_view =
      hn::And(hn::Ge(distance, hn::Set(d, kMinParticleDistance)), hn::And(in_columns, in_rows));
  hn::StoreU(hn::ConvertTo(di, hn::IfThenElseZero(in_view, left)), di, batch.left + first);
  hn::StoreU(hn::ConvertTo(di, hn::IfThenElseZero(in_view, top)), di, batch.top + first);
  hn::StoreU(hn::ConvertTo(di, hn::IfThenElseZero(in_view, side)), di, batch.side + first);
  const VF depth = kPerspective ? nearness : hn::Neg(distance);
  hn::StoreU(hn::IfThenElseZero(in_view, depth), d, batch.depth + first);
}

void ProjectParticles(const ParticleProjection& projection, const ParticleBatch& batch) {
  const size_t lanes = hn::Lanes(DF());
  size_t i = 0;
  if (projection.perspective)
    for (; i + lanes <= batch.count; i += lanes) ProjectVector<true>(projection, batch, i);
  else
    for (; i + lanes <= batch.count; i += lanes) ProjectVector<false>(projection, batch, i);
  project_particles_scalar(projection, {batch.x + i, batch.y + i, batch.z + i, batch.count - i,
                                        batch.left + i, batch.top + i, batch.side + i, batch.depth + i});
}

HWY_INLINE void StoreWhere(hn::Mask<DU> mask, uint32_t color, uint32_t* pixels) {
  hn::BlendedStore(hn::Set(DU(), color), mask, DU(), pixels);
}
HWY_INLINE void StoreWhere(hn::Mask<DU> mask, uint32_t color, uint8_t* pixels) {
  const D8 d8;
#if HWY_TARGET <= HWY_AVX3
  _mm_mask_storeu_epi8(pixels, static_cast<__mmask16>(mask.raw), _mm_set1_epi8(static_cast<char>(color)));
#else
  const auto taken = hn::TruncateTo(d8, hn::VecFromMask(DU(), mask));
  const auto old = hn::LoadU(d8, pixels);
  hn::StoreU(hn::IfThenElse(hn::MaskFromVec(taken), hn::Set(d8, static_cast<uint8_t>(color)), old), d8,
             pixels);
#endif
}

// Pixels right of the rectangle are neither read nor written: they may belong to another band that is drawn
// at the same time.
template <typename Pixel>
HWY_INLINE void DrawRow(const ParticleRect& rect, size_t first, const ParticleTarget& target) {
  const DF d;
  const size_t lanes = hn::Lanes(d);
  Pixel* const pixels = static_cast<Pixel*>(target.pixels) + first;
  float* const depth = target.depth + first;
  const VF own_depth = hn::Set(d, rect.depth);
  size_t i = 0;
  for (; i + lanes <= rect.width; i += lanes) {
    const auto nearer = hn::Le(hn::LoadU(d, depth + i), own_depth);
    StoreWhere(hn::RebindMask(DU(), nearer), rect.color, pixels + i);
    hn::BlendedStore(own_depth, nearer, d, depth + i);
  }
#if HWY_TARGET <= HWY_AVX3
  if (i == rect.width) return;
  const auto rest = hn::FirstN(d, rect.width - i);
  const auto nearer = hn::And(rest, hn::Le(hn::MaskedLoad(rest, d, depth + i), own_depth));
  StoreWhere(hn::RebindMask(DU(), nearer), rect.color, pixels + i);
  hn::BlendedStore(own_depth, nearer, d, depth + i);
#else
  const Pixel color = static_cast<Pixel>(rect.color);
  for (; i < rect.width; ++i) {
    const bool nearer = depth[i] <= rect.depth;
    pixels[i] = nearer ? color : pixels[i];
    depth[i] = nearer ? rect.depth : depth[i];
  }
#endif
}

template <typename Pixel>
HWY_INLINE void DrawRects(const ParticleRect* HWY_RESTRICT rects, size_t count,
                          const ParticleTarget& target) {
  for (size_t i = 0; i < count; ++i) {
    const ParticleRect& rect = rects[i];
    for (size_t row = 0; row < rect.height; ++row)
      DrawRow<Pixel>(rect, (rect.y + row) * target.width + rect.x, target);
  }
}

void DrawParticlesU8(const ParticleRect* rects, size_t count, const ParticleTarget& target) {
  DrawRects<uint8_t>(rects, count, target);
}
void DrawParticlesU32(const ParticleRect* rects, size_t count, const ParticleTarget& target) {
  DrawRects<uint32_t>(rects, count, target);
}

#endif

}  // namespace temblor::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace temblor::render {

HWY_EXPORT(ProjectParticles);
HWY_EXPORT(DrawParticlesU8);
HWY_EXPORT(DrawParticlesU32);

void project_particles_simd(const ParticleProjection& projection, const ParticleBatch& batch) {
  HWY_DYNAMIC_DISPATCH(ProjectParticles)(projection, batch);
}
void draw_particles_u8_simd(const ParticleRect* rects, std::size_t count, const ParticleTarget& target) {
  HWY_DYNAMIC_DISPATCH(DrawParticlesU8)(rects, count, target);
}
void draw_particles_u32_simd(const ParticleRect* rects, std::size_t count, const ParticleTarget& target) {
  HWY_DYNAMIC_DISPATCH(DrawParticlesU32)(rects, count, target);
}

}  // namespace temblor::render
#endif
