// Pictures held against ones that a person has looked at: PNG files in the folder tests/golden/pictures.
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <string>

#include "formats/images/image.h"

namespace temblor::test {

// Frames are the same on every machine but for what compilers and libraries make of sines and powers, which
// moves an edge by a pixel here and there; and one wrong thing that is small must not hide in that.
struct Tolerance {
  int step = 0;                     // channels no further apart than this are equal
  double differing_percent = 0.25;  // of all pixels, may differ
  std::size_t far_off = 4;          // pixels may differ by more than kFarOff in a channel
};
constexpr int kFarOff = 32;  // of 255

// Succeeds where `got` is `expected` within the tolerance, else says how many pixels differ by how much.
// Opacity is not looked at. Pictures of different sizes differ.
::testing::AssertionResult is_like(const formats::Image& expected, const formats::Image& got,
                                   const Tolerance& tolerance);

// Expected, got, and how they differ (eight times the difference of each channel), side by side; or the two
// alone where their sizes differ.
formats::Image side_by_side(const formats::Image& expected, const formats::Image& got);

// Holds `png` against tests/golden/pictures/NAME.png. Where they differ, writes both and their difference to
// the folder golden-failures of the build and says so. With TEMBLOR_REWRITE_GOLDENS set, writes the golden
// picture instead and skips the test.
void expect_golden(const std::string& name, base::Bytes png, const Tolerance& tolerance);

}  // namespace temblor::test
