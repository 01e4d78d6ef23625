// Things to draw: boxes and floors of triangles, and the lines around them.
#pragma once

#include "lab/school/triangles.h"

namespace temblor::lab::school {

using Mesh = std::vector<std::array<Vertex, 3>>;

// Adds two triangles between corners that go around a quadrilateral; s and t go from 0 to `repeats`.
void add_quad(Mesh& io_mesh, const std::array<Vector, 4>& corners, const Color& color, float repeats = 1);

// A box around the origin, 2 units wide. Each side has its own color.
Mesh make_box();
// A floor at height -1, from z = 0 to `length`, with a texture that repeats every unit.
Mesh make_floor(float half_width, float length);

// The triangles of a mesh in the picture.
std::vector<ScreenTriangle> project_mesh(const Mesh& mesh, const Matrix& movement, const View& view);

// The light on a triangle from a direction (length 1): most when it faces the light, and never quite nothing.
float find_light(const std::array<Vector, 3>& corners, const Vector& to_light);

void draw_outline(Picture& io_picture, const ScreenTriangle& triangle, const Color& color);

// A texture of bricks, 64 texels wide.
Picture make_bricks();

}  // namespace temblor::lab::school
