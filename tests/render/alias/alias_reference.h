// The reference picture of a scene's alias models, pixel by pixel: rays against triangles in double
// precision, from the file's model and the definitions in scene.h, without the renderer's code.
#pragma once

#include <span>
#include <vector>

#include "formats/models/mdl.h"
#include "math/angles.h"
#include "render/scene.h"

namespace temblor::test {

struct ReferencePicture {
  int width, height;
  double focal_px;  // pixels a unit at distance 1
  math::Vec3d eye;
  math::Basis axes;
};
ReferencePicture reference_picture(const render::Camera& camera, int width, int height);

// Triangles in view space (x right, y up, z forward), three corners each, with texels.
struct ReferenceCorner {
  math::Vec3d view;
  double s, t;
};
struct ReferenceMesh {
  std::vector<ReferenceCorner> corners;  // three a triangle, clockwise seen from outside
  std::vector<math::Vec3d> normals;      // one a triangle, outward, of any length
};
// Number `pose` of the model's poses, in file order, with the instance's placement.
ReferenceMesh reference_mesh(const formats::Mdl& mdl, std::size_t pose, const render::AliasInstance& instance,
                             const ReferencePicture& picture);

struct ReferenceHit {
  bool hit = false;
  double depth = 0;  // 1/z
  double s = 0, t = 0;
  std::size_t triangle = 0;
};
// The nearest front face at screen position (x, y), with pixel centers at whole numbers, not nearer than
// near_z.
ReferenceHit reference_hit(const ReferenceMesh& mesh, const ReferencePicture& picture, double x, double y,
                           double near_z);

}  // namespace temblor::test
