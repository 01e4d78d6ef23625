// Fixed point: fractions as whole numbers, counted in 65,536ths. Processors without fast floating point drew
// this way.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "lab/school/spans.h"

namespace temblor::lab::school {

// 16 bits before the point and 16 behind it: from -32768 to nearly 32768.
struct Fixed {
  std::int32_t raw = 0;

  static constexpr int kFractionBits = 16;
  static Fixed from(float value) {
    return {static_cast<std::int32_t>(std::lround(value * (1 << kFractionBits)))};
  }
  float to_float() const { return static_cast<float>(raw) / (1 << kFractionBits); }
  // The first pixel whose center is here or beyond: adds a half less one 65,536th, and drops the fraction.
  int first_pixel() const { return (raw + (1 << (kFractionBits - 1)) - 1) >> kFractionBits; }
};

inline Fixed operator+(Fixed a, Fixed b) {
  return {a.raw + b.raw};
}
inline Fixed operator-(Fixed a, Fixed b) {
  return {a.raw - b.raw};
}
// A product has 32 bits behind the point; half of them are dropped.
inline Fixed operator*(Fixed a, Fixed b) {
  return {static_cast<std::int32_t>(std::int64_t{a.raw} * b.raw >> Fixed::kFractionBits)};
}
// The dividend gets 16 bits more, so that the quotient has 16.
inline Fixed operator/(Fixed a, Fixed b) {
  return {static_cast<std::int32_t>((std::int64_t{a.raw} << Fixed::kFractionBits) / b.raw)};
}

// find_spans() in fixed point, with one addition per row and edge. Slopes are rounded, so a span may differ
// by a pixel. All corners must be in the picture, which has at most 4096 pixels on a side.
std::vector<Span> find_spans_in_fixed_point(Corners corners);

}  // namespace temblor::lab::school
