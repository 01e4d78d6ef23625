// Vectors and matrices: places and movements in space. x points right, y up, and z away from the viewer.
#pragma once

#include <array>
#include <cmath>

namespace temblor::lab::school {

struct Vector {
  float x = 0, y = 0, z = 0;
};

inline Vector operator+(const Vector& a, const Vector& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vector operator-(const Vector& a, const Vector& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vector operator*(const Vector& a, float factor) {
  return {a.x * factor, a.y * factor, a.z * factor};
}

// For vectors of length 1, the cosine of the angle between them: how much one goes the other's way.
inline float dot(const Vector& a, const Vector& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

// A vector at right angles to both.
inline Vector cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

inline float length(const Vector& vector) {
  return std::sqrt(dot(vector, vector));
}
inline Vector normalize(const Vector& vector) {
  return vector * (1 / length(vector));
}

// Four rows of four. The fourth column moves; the fourth row stays 0 0 0 1.
using Matrix = std::array<std::array<float, 4>, 4>;

inline Matrix move_by(const Vector& way) {
  return {{{1, 0, 0, way.x}, {0, 1, 0, way.y}, {0, 0, 1, way.z}, {0, 0, 0, 1}}};
}
inline Matrix scale_by(float factor) {
  return {{{factor, 0, 0, 0}, {0, factor, 0, 0}, {0, 0, factor, 0}, {0, 0, 0, 1}}};
}
inline Matrix turn_around_x(float angle_rad) {
  const float c = std::cos(angle_rad), s = std::sin(angle_rad);
  return {{{1, 0, 0, 0}, {0, c, -s, 0}, {0, s, c, 0}, {0, 0, 0, 1}}};
}
inline Matrix turn_around_y(float angle_rad) {
  const float c = std::cos(angle_rad), s = std::sin(angle_rad);
  return {{{c, 0, s, 0}, {0, 1, 0, 0}, {-s, 0, c, 0}, {0, 0, 0, 1}}};
}

// Does `second`, then `first`: rows of one times columns of the other. The order matters.
inline Matrix operator*(const Matrix& first, const Matrix& second) {
  Matrix product{};
  for (std::size_t row = 0; row < 4; ++row)
    for (std::size_t column = 0; column < 4; ++column)
      for (std::size_t i = 0; i < 4; ++i) product[row][column] += first[row][i] * second[i][column];
  return product;
}

inline Vector operator*(const Matrix& matrix, const Vector& v) {
  const auto row = [&](std::size_t i) {
    return matrix[i][0] * v.x + matrix[i][1] * v.y + matrix[i][2] * v.z + matrix[i][3];
  };
  return {row(0), row(1), row(2)};
}

}  // namespace temblor::lab::school
