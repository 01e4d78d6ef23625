// Small triangles by precompiled code: each shape of triangle-masks has drawing code of its own, without a
// loop over its pixels. Triangles that reach out of the screen or of a band of rows are drawn by their masks,
// and large ones by the engine's scan lines. The picture is that of triangle-masks.
//
// Parameters:
//   side  triangles up to so many pixels high and wide have code
//   code  0: C++ that is written when Temblor is built; 1: x86-64 code that asmjit assembles at the start
#pragma once

#include "lab/technique.h"

namespace temblor::lab {

// With code that this machine cannot run: no stages, so the engine draws.
render::FrameStages make_compiled_triangles(std::span<const double> values, Counter* counter);

// Fails with kUnsupported and one line if code cannot be made at run time.
base::Status check_compiled_triangles(std::span<const double> values, const world::Level& level);

}  // namespace temblor::lab
