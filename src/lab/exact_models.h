// The exact picture of a scene's alias models, and models whose pictures show texel coordinates, to measure
// the errors of techniques that draw models.
//
// The exact picture follows a ray through the center of each pixel, in double precision: without rounded
// vertices, and in perspective.
#pragma once

#include <memory>
#include <vector>

#include "formats/images/palette.h"
#include "render/scene.h"

namespace temblor::lab {

struct ModelPixel {
  bool hit = false;
  double depth = 0;     // 1/z of the nearest front face
  double s = 0, t = 0;  // texels; middles of texels are at .5
};

// The opaque models of Scene::alias_models, in perspective, row by row. Time grows with the pixels of all
// triangles.
std::vector<ModelPixel> draw_exact_models(const render::Scene& scene, int width, int height);

// The model with other skins: the palette index of each texel is its column (axis 0) or row (axis 1), modulo
// 256.
std::shared_ptr<const render::AliasModel> make_coordinate_model(const render::AliasModel& model, int axis);

// Shows palette indices as they are, in any light.
formats::Colormap make_unlit_colormap();

}  // namespace temblor::lab
