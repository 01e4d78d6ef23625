// The rule for which pixels lie between two edges on a row. The edge scan and the scan of deferred faces
// share it, so that a face covers the same pixels either way: pixel centers are at whole numbers, and a pixel
// whose center is exactly on an edge lies to the right of it.
#pragma once

namespace temblor::render {

// The x at which an edge crosses a row; 0 if that is left of the screen.
inline double crossing(double x_first, double step, double rows_below_first) {
  const double x = x_first + step * rows_below_first;
  return x > 0 ? x : 0;  // the order of comparison that is one instruction
}

// The first pixel whose center is not left of x; x is at least 0. (std::ceil would be a function call on
// processors without SSE 4.1.)
inline int first_pixel(double x) {
  const int whole = static_cast<int>(x);
  return whole + (x > whole ? 1 : 0);
}

}  // namespace temblor::render
