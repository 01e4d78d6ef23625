// Inner loops over spans of a skybox, as vector code and as plain C++ with the same results, bit for bit.
// Only plain types here: the vector file is compiled for several processors.
//
// The side is that of the ray's largest component (x before y before z where two are as large). Along it
// u = (1 + s) * size / 2 + 1/2 with s from -1 to 1, and v alike: texels of the side with its border, whose
// centers are at whole numbers. Bytes: the nearest texel. Colors: the mean of four, in 256ths.
#pragma once

#include <cstddef>
#include <cstdint>

#include "render/spans/span_kernels.h"

namespace temblor::render {

// The ray of pixel (x, y) is forward + x * right + y * down.
struct SkyboxRuns {
  KernelPlane depth;
  double forward[3], right[3], down[3];
  const void* texels;  // bytes or 0xffRRGGBB: +x, +y, -x, -y, +z, -z, each (size + 2) squared
  std::int32_t size;   // 1 to 2048
  const SpanRun* runs;
  std::size_t run_count;
};

void draw_skybox_runs_u8_scalar(const SkyboxRuns& runs, const KernelTarget& target);
void draw_skybox_runs_u32_scalar(const SkyboxRuns& runs, const KernelTarget& target);
void draw_skybox_runs_u8_simd(const SkyboxRuns& runs, const KernelTarget& target);
void draw_skybox_runs_u32_simd(const SkyboxRuns& runs, const KernelTarget& target);

// One run, pixels [first, run.count) of it.
void draw_skybox_run_u8_scalar(const SkyboxRuns& runs, const SpanRun& run, std::int32_t first,
                               const KernelTarget& target);
void draw_skybox_run_u32_scalar(const SkyboxRuns& runs, const SpanRun& run, std::int32_t first,
                                const KernelTarget& target);

}  // namespace temblor::render
