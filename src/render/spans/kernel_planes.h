// Between the stages' types and the kernels' plain ones.
#pragma once

#include "render/edges/span_table.h"
#include "render/spans/span_kernels.h"
#include "render/view/view_frame.h"

namespace temblor::render {

static_assert(sizeof(SpanRun) == sizeof(KernelRun));

inline KernelPlane kernel_plane(const ScreenPlane& plane) {
  return {plane.at_origin, plane.dx, plane.dy};
}
inline const KernelRun* kernel_runs(std::span<const SpanRun> runs) {
  return reinterpret_cast<const KernelRun*>(runs.data());
}

}  // namespace temblor::render
