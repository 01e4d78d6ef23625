#include "lab/school/scene.h"

#include <algorithm>

namespace temblor::lab::school {

void add_quad(Mesh& io_mesh, const std::array<Vector, 4>& corners, const Color& color, float repeats) {
  const std::array<Vertex, 4> v{Vertex{corners[0], color, 0, 0}, Vertex{corners[1], color, repeats, 0},
                                Vertex{corners[2], color, repeats, repeats},
                                Vertex{corners[3], color, 0, repeats}};
  io_mesh.push_back({v[0], v[1], v[2]});
  io_mesh.push_back({v[0], v[2], v[3]});
}

// Seen from outside, corners go clockwise, so that cross() of two sides points inward.
Mesh make_box() {
  Mesh box;
  add_quad(box, {{{-1, 1, -1}, {1, 1, -1}, {1, -1, -1}, {-1, -1, -1}}}, {0.9f, 0.35f, 0.25f});
  add_quad(box, {{{1, 1, 1}, {-1, 1, 1}, {-1, -1, 1}, {1, -1, 1}}}, {0.9f, 0.7f, 0.25f});
  add_quad(box, {{{-1, 1, 1}, {-1, 1, -1}, {-1, -1, -1}, {-1, -1, 1}}}, {0.3f, 0.6f, 0.9f});
  add_quad(box, {{{1, 1, -1}, {1, 1, 1}, {1, -1, 1}, {1, -1, -1}}}, {0.4f, 0.8f, 0.4f});
  add_quad(box, {{{-1, 1, 1}, {1, 1, 1}, {1, 1, -1}, {-1, 1, -1}}}, {0.85f, 0.85f, 0.85f});
  add_quad(box, {{{-1, -1, -1}, {1, -1, -1}, {1, -1, 1}, {-1, -1, 1}}}, {0.6f, 0.4f, 0.8f});
  return box;
}

Mesh make_floor(float half_width, float length) {
  Mesh floor;
  const float w = half_width;
  add_quad(floor, {{{-w, -1, length}, {w, -1, length}, {w, -1, 0}, {-w, -1, 0}}}, {0.7f, 0.7f, 0.7f}, length);
  return floor;
}

std::vector<ScreenTriangle> project_mesh(const Mesh& mesh, const Matrix& movement, const View& view) {
  std::vector<ScreenTriangle> triangles;
  for (const auto& triangle : mesh)
    for (const ScreenTriangle& part : project_triangle(triangle, movement, view)) triangles.push_back(part);
  return triangles;
}

float find_light(const std::array<Vector, 3>& corners, const Vector& to_light) {
  constexpr float kAmbient = 0.25f;
  const Vector outward = normalize(cross(corners[2] - corners[0], corners[1] - corners[0])) * -1;
  return kAmbient + (1 - kAmbient) * std::max(0.0f, dot(outward, to_light));
}

void draw_outline(Picture& io_picture, const ScreenTriangle& triangle, const Color& color) {
  for (std::size_t i = 0; i < 3; ++i) draw_line(io_picture, triangle[i].at, triangle[(i + 1) % 3].at, color);
}

Picture make_bricks() {
  constexpr int kSide = 64, kHeight = 16, kWidth = 32;
  Picture bricks(kSide, kSide, {0.75f, 0.72f, 0.68f});
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const int row = y / kHeight, along = (x + row % 2 * kWidth / 2) % kWidth;
      if (y % kHeight < 2 || along < 2) continue;
      const float shade =
          0.8f + 0.05f * static_cast<float>((row * 3 + (x + row % 2 * kWidth / 2) / kWidth) % 4);
      bricks.color(x, y) = Color{0.72f, 0.33f, 0.22f} * shade;
    }
  return bricks;
}

}  // namespace temblor::lab::school
