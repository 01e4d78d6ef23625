#include "lab/school/triangles.h"

#include <algorithm>
#include <cmath>

namespace temblor::lab::school {
namespace {

Corners find_corners(const ScreenTriangle& triangle) {
  return {triangle[0].at, triangle[1].at, triangle[2].at};
}

// The gradient of a value that `value` reads from each corner.
template <typename Value>
Gradient find_gradient_of(const ScreenTriangle& triangle, Value value) {
  return find_gradient(find_corners(triangle), {value(triangle[0]), value(triangle[1]), value(triangle[2])});
}

// Calls draw(x, y, center_x, center_y) for each pixel.
template <typename Draw>
void for_each_pixel(const Picture& picture, const ScreenTriangle& triangle, Draw draw) {
  for (const Span& span : find_spans(find_corners(triangle), picture.width(), picture.height()))
    for (int x = span.begin; x < span.end; ++x)
      draw(x, span.y, static_cast<float>(x) + 0.5f, static_cast<float>(span.y) + 0.5f);
}

Gradient find_inverse_depth(const ScreenTriangle& triangle) {
  return find_gradient_of(triangle, [](const ScreenCorner& corner) { return corner.inverse_depth; });
}

// Where a pixel lies in the texture.
struct TexturePlane {
  Gradient s_over_z, t_over_z, one_over_z;

  explicit TexturePlane(const ScreenTriangle& triangle)
      : s_over_z(find_gradient_of(triangle, [](const auto& c) { return c.s * c.inverse_depth; })),
        t_over_z(find_gradient_of(triangle, [](const auto& c) { return c.t * c.inverse_depth; })),
        one_over_z(find_inverse_depth(triangle)) {}

  Point at(float x, float y) const {
    const float z = 1 / one_over_z.at(x, y);
    return {s_over_z.at(x, y) * z, t_over_z.at(x, y) * z};
  }
};

}  // namespace

std::vector<ScreenTriangle> project_triangle(const std::array<Vertex, 3>& triangle, const Matrix& movement,
                                             const View& view) {
  std::vector<Vertex> moved(triangle.begin(), triangle.end());
  for (Vertex& vertex : moved) vertex.place = movement * vertex.place;
  std::vector<ScreenCorner> corners;
  for (const Vertex& vertex : clip_to_near_plane(moved, view.near))
    corners.push_back(
        {project_perspective(vertex.place, view), 1 / vertex.place.z, vertex.color, vertex.s, vertex.t});
  std::vector<ScreenTriangle> triangles;
  for (std::size_t i = 2; i < corners.size(); ++i)
    triangles.push_back({corners[0], corners[i - 1], corners[i]});
  return triangles;
}

void fill_flat(Picture& io_picture, const ScreenTriangle& triangle, const Color& color) {
  for_each_pixel(io_picture, triangle, [&](int x, int y, float, float) { io_picture.color(x, y) = color; });
}

void fill_gouraud(Picture& io_picture, const ScreenTriangle& triangle) {
  const Gradient red = find_gradient_of(triangle, [](const auto& c) { return c.color.red; });
  const Gradient green = find_gradient_of(triangle, [](const auto& c) { return c.color.green; });
  const Gradient blue = find_gradient_of(triangle, [](const auto& c) { return c.color.blue; });
  for_each_pixel(io_picture, triangle, [&](int x, int y, float center_x, float center_y) {
    io_picture.color(x, y) = {red.at(center_x, center_y), green.at(center_x, center_y),
                              blue.at(center_x, center_y)};
  });
}

void fill_affine(Picture& io_picture, const ScreenTriangle& triangle, const Picture& texture) {
  const Gradient s = find_gradient_of(triangle, [](const auto& c) { return c.s; });
  const Gradient t = find_gradient_of(triangle, [](const auto& c) { return c.t; });
  for_each_pixel(io_picture, triangle, [&](int x, int y, float center_x, float center_y) {
    io_picture.color(x, y) = read_texel(texture, s.at(center_x, center_y), t.at(center_x, center_y));
  });
}

void fill_textured(Picture& io_picture, const ScreenTriangle& triangle, const Picture& texture) {
  const TexturePlane plane(triangle);
  for_each_pixel(io_picture, triangle, [&](int x, int y, float center_x, float center_y) {
    const Point at = plane.at(center_x, center_y);
    io_picture.color(x, y) = read_texel(texture, at.x, at.y);
  });
}

// The next pixels to the right and below tell how many texels a pixel is wide.
void fill_mip_mapped(Picture& io_picture, const ScreenTriangle& triangle, std::span<const Picture> levels) {
  const TexturePlane plane(triangle);
  const auto side = static_cast<float>(levels[0].width());
  for_each_pixel(io_picture, triangle, [&](int x, int y, float center_x, float center_y) {
    const Point at = plane.at(center_x, center_y);
    const Point right = plane.at(center_x + 1, center_y), below = plane.at(center_x, center_y + 1);
    const float wide = std::hypot(right.x - at.x, right.y - at.y),
                high = std::hypot(below.x - at.x, below.y - at.y);
    const std::size_t level = choose_mip_level(side * std::max(wide, high), levels.size());
    io_picture.color(x, y) = read_texel(levels[level], at.x, at.y);
  });
}

void fill_multi_textured(Picture& io_picture, const ScreenTriangle& triangle, const Picture& texture,
                         const Picture& light, float light_scale) {
  const TexturePlane plane(triangle);
  for_each_pixel(io_picture, triangle, [&](int x, int y, float center_x, float center_y) {
    const Point at = plane.at(center_x, center_y);
    io_picture.color(x, y) =
        read_texel(texture, at.x, at.y) * read_texel(light, at.x * light_scale, at.y * light_scale);
  });
}

void fill_blended(Picture& io_picture, const ScreenTriangle& triangle, const Color& color, float opacity) {
  for_each_pixel(io_picture, triangle, [&](int x, int y, float, float) {
    io_picture.color(x, y) = interpolate(io_picture.color(x, y), color, opacity);
  });
}

void fill_with_depth_buffer(Picture& io_picture, const ScreenTriangle& triangle, const Color& color) {
  const Gradient inverse_depth = find_inverse_depth(triangle);
  for_each_pixel(io_picture, triangle, [&](int x, int y, float center_x, float center_y) {
    const float nearness = inverse_depth.at(center_x, center_y);
    if (nearness <= io_picture.inverse_depth(x, y)) return;
    io_picture.inverse_depth(x, y) = nearness;
    io_picture.color(x, y) = color;
  });
}

void sort_back_to_front(std::vector<ScreenTriangle>& io_triangles) {
  const auto depth = [](const ScreenTriangle& triangle) {
    float sum = 0;
    for (const ScreenCorner& corner : triangle) sum += 1 / corner.inverse_depth;
    return sum;
  };
  std::ranges::stable_sort(io_triangles, std::ranges::greater{}, depth);
}

}  // namespace temblor::lab::school
