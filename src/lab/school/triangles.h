// Triangles with colors, textures, and depth. Each function is one way to fill the spans.
#pragma once

#include <array>
#include <span>

#include "lab/school/clipping.h"
#include "lab/school/projection.h"
#include "lab/school/spans.h"
#include "lab/school/texture.h"

namespace temblor::lab::school {

// A corner in the picture.
struct ScreenCorner {
  Point at;
  float inverse_depth = 1;
  Color color{};
  float s = 0, t = 0;
};
using ScreenTriangle = std::array<ScreenCorner, 3>;

// Moves a triangle in front of the viewer, clips it, and projects it: 0, 1, or 2 triangles.
std::vector<ScreenTriangle> project_triangle(const std::array<Vertex, 3>& triangle, const Matrix& movement,
                                             const View& view);

// Flat: one color.
void fill_flat(Picture& io_picture, const ScreenTriangle& triangle, const Color& color);
// Gouraud: the corners' colors change evenly from one to the next.
void fill_gouraud(Picture& io_picture, const ScreenTriangle& triangle);
// Affine: texture coordinates change evenly in the picture, which is wrong in perspective.
void fill_affine(Picture& io_picture, const ScreenTriangle& triangle, const Picture& texture);
// s/z, t/z, and 1/z change evenly in the picture. One division per pixel gives s and t.
void fill_textured(Picture& io_picture, const ScreenTriangle& triangle, const Picture& texture);
// The same with a mip level for each pixel.
void fill_mip_mapped(Picture& io_picture, const ScreenTriangle& triangle, std::span<const Picture> levels);
// Two textures, multiplied: a pattern, and light over the whole of it, which does not repeat.
void fill_multi_textured(Picture& io_picture, const ScreenTriangle& triangle, const Picture& texture,
                         const Picture& light, float light_scale);
// Blended: `opacity` of the color, and the rest of the picture behind it.
void fill_blended(Picture& io_picture, const ScreenTriangle& triangle, const Color& color, float opacity);
// Draws a pixel only where it is nearer than what is there.
void fill_with_depth_buffer(Picture& io_picture, const ScreenTriangle& triangle, const Color& color);

// Depth sorting: the order from the farthest to the nearest, by the mean of the corners' depths. Triangles
// that overlap in a circle have no right order.
void sort_back_to_front(std::vector<ScreenTriangle>& io_triangles);

}  // namespace temblor::lab::school
