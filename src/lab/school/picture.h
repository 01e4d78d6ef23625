// The school: a beginner's renderer, apart from the engine's. Each file is one step from a straight line to a
// scene with depth. Nothing here is fast; everything is short. lessons.cpp has the order and the pictures.
//
// This file: a picture, and a depth for each of its pixels.
#pragma once

#include <cstddef>
#include <vector>

namespace temblor::lab::school {

// Each channel from 0 to 1.
struct Color {
  float red = 0, green = 0, blue = 0;
};

inline Color operator*(const Color& color, float factor) {
  return {color.red * factor, color.green * factor, color.blue * factor};
}
inline Color operator*(const Color& a, const Color& b) {
  return {a.red * b.red, a.green * b.green, a.blue * b.blue};
}
inline Color operator+(const Color& a, const Color& b) {
  return {a.red + b.red, a.green + b.green, a.blue + b.blue};
}

// Pixel (0, 0) is at the top left. It covers 0 to 1 on both axes, so its center is at (0.5, 0.5).
class Picture {
 public:
  Picture(int width, int height, Color background = {0.09f, 0.1f, 0.13f})
      : width_(width),
        colors_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), background),
        inverse_depths_(colors_.size(), 0) {}

  int width() const { return width_; }
  int height() const { return static_cast<int>(colors_.size()) / width_; }
  bool has(int x, int y) const { return x >= 0 && x < width_ && y >= 0 && y < height(); }

  Color& color(int x, int y) { return colors_[index(x, y)]; }
  const Color& color(int x, int y) const { return colors_[index(x, y)]; }
  // 1 / depth, so that 0 is infinitely far and larger is nearer.
  float& inverse_depth(int x, int y) { return inverse_depths_[index(x, y)]; }

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }

  int width_;
  std::vector<Color> colors_;
  std::vector<float> inverse_depths_;
};

}  // namespace temblor::lab::school
