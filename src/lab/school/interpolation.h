// Interpolation: values between two known ones. Edges, light, and textures all use it.
#pragma once

#include <algorithm>
#include <cmath>

#include "lab/school/picture.h"

namespace temblor::lab::school {

// A place in a picture, in pixels.
struct Point {
  float x = 0, y = 0;
};

// `share` goes from 0 (`from`) to 1 (`to`).
inline float interpolate(float from, float to, float share) {
  return from + (to - from) * share;
}

inline Color interpolate(const Color& from, const Color& to, float share) {
  return from * (1 - share) + to * share;
}

// A straight line changes by the same amount with each step, so a step needs one addition and no
// multiplication.
class EvenSteps {
 public:
  EvenSteps(float from, float to, int steps)
      : value_(from), step_(steps > 0 ? (to - from) / static_cast<float>(steps) : 0) {}
  float value() const { return value_; }
  void advance() { value_ += step_; }

 private:
  float value_, step_;
};

// Steps along the axis on which the line is longer, so that it has no gaps.
inline void draw_line(Picture& io_picture, const Point& from, const Point& to, const Color& color) {
  const int steps = static_cast<int>(std::ceil(std::max(std::abs(to.x - from.x), std::abs(to.y - from.y))));
  EvenSteps x(from.x, to.x, steps), y(from.y, to.y, steps);
  for (int i = 0; i <= steps; ++i, x.advance(), y.advance()) {
    const int column = static_cast<int>(std::floor(x.value())), row = static_cast<int>(std::floor(y.value()));
    if (io_picture.has(column, row)) io_picture.color(column, row) = color;
  }
}

}  // namespace temblor::lab::school
