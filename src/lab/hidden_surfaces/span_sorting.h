// Span sorting: each face is turned into spans, and each span is clipped against the bucket of its row, which
// holds the nearest spans so far, from left to right and without overlap:
//
//   bucket      |--A--|         |----B----|
//   new span C     |------C------|                  farther than A, nearer than B
//   bucket      |--A--|----C-----|---B----|
//
// Parameter `depth` 1 compares spans by 1/z; 0 by BSP order, so that a face which is taken from front to back
// only fills gaps.
#pragma once

#include "lab/technique.h"

namespace temblor::lab {

render::FrameStages make_span_sorting(std::span<const double> values, Counter* counter);

}  // namespace temblor::lab
