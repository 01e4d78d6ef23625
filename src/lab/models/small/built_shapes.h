// Drawing code for each shape of a small triangle, as C++ that a program of the build writes
// (generator/write_shape_code.cpp): no loop and no mask, one statement for each pixel.
#pragma once

#include <cstdint>
#include <span>

#include "lab/models/small/small_pixels.h"

namespace temblor::lab {

// Draws the pixels of a shape. The first pixel of the drawing is at the top left of the shape's box.
using DrawShape = void (*)(const SmallDrawing&);

struct BuiltShapes {
  std::span<const std::uint32_t> masks;     // in the order of SmallShapes
  std::span<const DrawShape> indexed, rgb;  // by shape
};

BuiltShapes list_built_shapes();

}  // namespace temblor::lab
