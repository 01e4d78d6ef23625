// Converts the planes of the stages to the plain type of the kernels.
#pragma once

#include "render/spans/span_kernels.h"
#include "render/view/view_frame.h"

namespace temblor::render {

inline KernelPlane kernel_plane(const ScreenPlane& plane) {
  return {plane.at_origin, plane.dx, plane.dy};
}

}  // namespace temblor::render
