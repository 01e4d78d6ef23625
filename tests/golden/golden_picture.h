// Compares pictures with approved ones: PNG files in the folder tests/golden/pictures.
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <string>

#include "formats/images/image.h"

namespace temblor::test {

// Frames are the same on every machine, except for differences in the sines and powers of compilers and
// libraries, which move an edge by a pixel here and there. A small error must not hide in that tolerance.
struct Tolerance {
  int step = 0;                     // channels no further apart than this are equal
  double differing_percent = 0.25;  // of all pixels, may differ
  std::size_t far_off = 4;          // pixels may differ by more than kFarOff in a channel
};
constexpr int kFarOff = 32;  // of 255

// Succeeds if `got` equals `expected` within the tolerance; otherwise says how many pixels differ by how
// much. Opacity is ignored. Pictures of different sizes differ.
::testing::AssertionResult is_like(const formats::Image& expected, const formats::Image& got,
                                   const Tolerance& tolerance);

// The expected picture, the actual one, and their difference (eight times per channel) side by side; only the
// first two if their sizes differ.
formats::Image side_by_side(const formats::Image& expected, const formats::Image& got);

// Compares `png` with tests/golden/pictures/NAME.png. On a difference, writes both and their difference to
// the build's folder golden-failures and reports it. If TEMBLOR_REWRITE_GOLDENS is set, writes the golden
// picture instead and skips the test.
void expect_golden(const std::string& name, base::Bytes png, const Tolerance& tolerance);

}  // namespace temblor::test
