// Inner loops over spans of a skybox, as SIMD and as the scalar reference with the same results, bit for bit.
// This header has plain types only, because the SIMD file is compiled for several processors.
//
// The ray's largest component selects the side (x before y before z where two are equal). On the side, u = (1
// + s) * size / 2 + 1/2 with s from -1 to 1, and v likewise: texels of the side with its border, whose
// centers are at whole numbers. Indexed frames take the nearest texel; rgb frames interpolate four texels, in
// 256ths.
#pragma once

#include <cstddef>
#include <cstdint>

#include "render/spans/span_kernels.h"

namespace temblor::render {

// The ray of pixel (x, y) is forward + x * right + y * down.
struct SkyboxSpans {
  KernelPlane depth;
  double forward[3], right[3], down[3];
  const void* texels;  // bytes or 0xffRRGGBB: +x, +y, -x, -y, +z, -z, each (size + 2) squared
  std::int32_t size;   // 1 to 2048
  const Span* spans;
  std::size_t span_count;
};

void draw_skybox_spans_u8_scalar(const SkyboxSpans& spans, const KernelTarget& target);
void draw_skybox_spans_u32_scalar(const SkyboxSpans& spans, const KernelTarget& target);
void draw_skybox_spans_u8_simd(const SkyboxSpans& spans, const KernelTarget& target);
void draw_skybox_spans_u32_simd(const SkyboxSpans& spans, const KernelTarget& target);

// Draws pixels [first, span.count) of one span: the remainder that does not fill a vector.
void draw_skybox_span_u8_scalar(const SkyboxSpans& spans, const Span& span, std::int32_t first,
                                const KernelTarget& target);
void draw_skybox_span_u32_scalar(const SkyboxSpans& spans, const Span& span, std::int32_t first,
                                 const KernelTarget& target);

}  // namespace temblor::render
