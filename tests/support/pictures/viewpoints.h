// Random scenes of a level: eyes at random points of open leaves, brush models at their places or moved away.
#pragma once

#include <vector>

#include "render/scene.h"
#include "support/random.h"
#include "world/level.h"

namespace temblor::test {

// Owns what a Scene only refers to.
struct Viewpoint {
  render::Camera camera;
  std::vector<render::BrushModelInstance> brush_models = {};
  double time_s = 0;
  std::vector<render::DynamicLight> lights = {};
  render::MarkSet marks = {};

  // Valid while this and the level live.
  render::Scene scene(const world::Level& level) const;
};

// The brush models that a game would show, where the level has them: every entity with a model "*N", triggers
// left out.
std::vector<render::BrushModelInstance> shown_brush_models(const world::Level& level);

// Moves every brush model by up to 64 units along each axis, and turns every third one about z, where it then
// keeps clear of the others: those that cut through one another are told apart only where an edge begins, in
// the original as here, and no picture of them is the right one.
void displace(const world::Level& level, std::span<render::BrushModelInstance> io_brush_models,
              Random& io_random);

// An eye in a random open leaf (each leaf as likely), looking anywhere, mostly level and upright, mostly with
// a field of view of 90 degrees. CHECKs that the level has an open leaf.
render::Camera random_camera(const world::Level& level, Random& io_random);

// Where players start and arrive, level and upright.
std::vector<render::Camera> player_cameras(const world::Level& level);

// Up to `most` lights of any color within 200 units of `middle_world`.
std::vector<render::DynamicLight> random_lights(const math::Vec3& middle_world, std::size_t most,
                                                Random& io_random);

// At corners of `count` of the level's faces.
render::MarkSet random_marks(const world::Level& level, std::size_t count, Random& io_random);

}  // namespace temblor::test
