#include "render_gl/methods/method_views.h"

#include <algorithm>
#include <iostream>

namespace temblor::render_gl {

namespace {

test::Viewpoint make_viewpoint(const world::Level& level, int number, const ViewContents& contents) {
  test::Random random(static_cast<std::uint64_t>(number));
  test::Viewpoint viewpoint{.camera = test::random_camera(level, random),
                            .brush_models = test::shown_brush_models(level),
                            .time_s = random.uniform(0, 100)};
  if (contents.with_turns) test::displace(level, viewpoint.brush_models, random);
  if (contents.with_turns)
    for (render::BrushModelInstance& model : viewpoint.brush_models)
      model.angles_deg = math::Vec3(random.uniform(-20, 20), random.uniform(0, 360), 0);
  viewpoint.lights = test::random_lights(viewpoint.camera.origin_world, contents.lights, random);
  if (contents.with_marks && number % 2 == 1) viewpoint.marks = test::random_marks(level, 20, random);
  if (contents.with_opacity && number % 3 == 2)
    for (render::BrushModelInstance& model : viewpoint.brush_models) model.alpha = 0.5f;
  return viewpoint;
}

}  // namespace

NumberedView::NumberedView(const world::Level& level, int number, const ViewContents& contents)
    : viewpoint(make_viewpoint(level, number, contents)), scene(viewpoint.scene(level)) {
  if (contents.with_opacity)
    scene.liquid_alpha = {.water = 0.5f, .slime = 0.7f, .lava = 0.9f, .teleport = 0.3f};
  if (contents.with_fog && number % 4 == 3) scene.fog = {.density = 0.2f, .color = {0.8f, 0.5f, 0.2f}};
  if (contents.with_fog && number % 8 == 7) {
    scene.camera.projection = render::Projection::kOrthographic;
    scene.camera.units_per_pixel = 1;
  }
  if (contents.with_styles) {
    test::Random random(static_cast<std::uint64_t>(number) + 1000);
    for (std::uint16_t& value : scene.light_styles) value = static_cast<std::uint16_t>(random.below(550));
  }
}

EqualShares compare_views(RendererPair& pair, const test::DrawableLevel& drawable, WorldMethod method,
                          int count, const ViewContents& contents, int tolerance) {
  pair.gl().set_method(method);
  EqualShares shares;
  for (int number = 0; number < count; ++number) {
    const NumberedView view(*drawable.level, number, contents);
    const double share = pair.compare(view.scene, {}, tolerance);
    shares.mean += share / count;
    shares.worst = std::min(shares.worst, share);
  }
  std::cout << "[          ] " << drawable.name << ", tolerance " << tolerance << ": equal " << shares.mean
            << ", worst view " << shares.worst << "\n";
  return shares;
}

}  // namespace temblor::render_gl
