// Which pixels an edge cuts a row between: the one rule for the edge list and for faces drawn by themselves.
#pragma once

namespace temblor::render {

// Where an edge crosses a row; 0 when left of the screen.
inline double crossing(double x_first, double step, double rows_below_first) {
  const double x = x_first + step * rows_below_first;
  return x > 0 ? x : 0;  // the order of comparison that is one instruction
}

// The first pixel whose center is not left of x, from 0 on. (std::ceil is a call on processors without
// SSE 4.1.)
inline int first_pixel(double x) {
  const int whole = static_cast<int>(x);
  return whole + (x > whole ? 1 : 0);
}

}  // namespace temblor::render
