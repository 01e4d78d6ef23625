// Random scenes of a level: eyes at random points of open leaves, and brush models at their places or moved.
#pragma once

#include <vector>

#include "render/scene.h"
#include "support/random.h"
#include "world/level.h"

namespace temblor::test {

// Owns the objects that a Scene refers to.
struct Viewpoint {
  render::Camera camera;
  std::vector<render::BrushModelInstance> brush_models = {};
  double time_s = 0;
  std::vector<render::DynamicLight> lights = {};
  render::MarkSet marks = {};

  // Valid as long as this object and the level.
  render::Scene scene(const world::Level& level) const;
};

// The brush models that a game would draw: every entity with a model "*N" that the level has, except
// triggers.
std::vector<render::BrushModelInstance> shown_brush_models(const world::Level& level);

// Moves every brush model by up to 64 units along each axis, and turns every third one about z if it then
// does not touch the others. Like in stock Quake, models that intersect are sorted only where an edge begins,
// so no picture of them is the correct one.
void displace(const world::Level& level, std::span<render::BrushModelInstance> io_brush_models,
              Random& io_random);

// An eye in a random open leaf (all equally likely), which looks in any direction, mostly level and upright,
// and mostly with a field of view of 90 degrees. CHECKs that the level has an open leaf.
render::Camera random_camera(const world::Level& level, Random& io_random);

// The places where players start and arrive, level and upright.
std::vector<render::Camera> player_cameras(const world::Level& level);

// Up to `max_count` lights of any color within 200 units of `middle_world`.
std::vector<render::DynamicLight> random_lights(const math::Vec3& middle_world, std::size_t max_count,
                                                Random& io_random);

// Marks at corners of `count` faces of the level.
render::MarkSet random_marks(const world::Level& level, std::size_t count, Random& io_random);

}  // namespace temblor::test
