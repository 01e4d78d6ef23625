// Scenes with alias models for the tests of the laboratory's techniques that draw models.
#pragma once

#include <memory>
#include <vector>

#include "lab/registry.h"
#include "render/renderer.h"
#include "support/levels/drawable_level.h"
#include "support/models/drawable_models.h"
#include "support/pictures/frames.h"
#include "support/pictures/viewpoints.h"
#include "support/random.h"

namespace temblor::test {

inline constexpr render::Settings kModelsAlone{.draw_world = false};

// A model whose triangles have no area: all vertices on a line, or in one point.
inline formats::Mdl flat_mdl(bool is_point) {
  formats::Mdl mdl = box_mdl();
  for (formats::MdlFrame& frame : mdl.frames)
    for (formats::MdlPose& pose : frame.poses)
      for (formats::MdlVertex& vertex : pose.vertices)
        vertex.position = {is_point ? std::uint8_t{100} : vertex.position[0], 100, 100};
  return mdl;
}

// Where the models of a scene are.
struct CrowdPlace {
  double least = 20, most = 600;  // units before the eye
  double spread = 0.5;            // to the sides, in units per unit of distance
  std::size_t count = 12;
};

// Models before a camera, on empty ground far from the level or inside of it.
struct ModelScene {
  std::vector<std::shared_ptr<const render::AliasModel>> models{
      small_model(sphere_mdl()), small_model(box_mdl()), small_model(many_pose_mdl()),
      small_model(flat_mdl(true)), small_model(flat_mdl(false))};
  std::vector<render::AliasInstance> instances;
  render::AliasInstance weapon;
  render::Scene scene;

  ModelScene(const DrawableLevel& drawable, Random& io_random, const CrowdPlace& place) {
    scene.level = drawable.level.get();
    scene.camera = random_camera(*drawable.level, io_random);
    add(io_random, place);
    weapon = instances.front();
    weapon.origin_world = scene.camera.origin_world + math::Vec3(axes().forward * 40.0);
    weapon.scale = 0.3f;
  }
  ModelScene(const ModelScene&) = delete;

  math::Basis axes() const { return math::basis_from_angles(scene.camera.angles_deg); }

  void add(Random& io_random, const CrowdPlace& place) {
    const math::Basis turn = axes();
    for (std::size_t i = 0; i < place.count; ++i) {
      render::AliasInstance& instance = instances.emplace_back();
      instance.model = models[i % models.size()].get();
      const double distance = io_random.log_uniform(place.least, place.most);
      const double right = io_random.uniform(-place.spread, place.spread) * distance;
      const double up = io_random.uniform(-place.spread, place.spread) * distance;
      instance.origin_world = math::Vec3(math::Vec3d(scene.camera.origin_world) + turn.forward * distance +
                                         turn.right * right + turn.up * up);
      instance.angles_deg = io_random.in_cube(180);
      instance.from_pose = render::pose_at(*instance.model, static_cast<std::uint32_t>(i % 9), 0.3);
      instance.to_pose = render::pose_at(*instance.model, static_cast<std::uint32_t>(i % 7), 0.1);
      instance.blend = static_cast<float>(io_random.uniform(0, 1));
      instance.min_light = 100;
    }
    scene.alias_models = instances;
  }
};

class ModelPictures {
 public:
  // `technique`: null for the engine.
  ModelPictures(const DrawableLevel& drawable, const char* technique, render::PixelFormat format)
      : ModelPictures(drawable.palette, drawable.colormap, technique, format) {}
  ModelPictures(const formats::Palette& palette, const formats::Colormap& colormap, const char* technique,
                render::PixelFormat format)
      : renderer_(palette, colormap), frame_(kWidth, kHeight, format) {
    if (technique != nullptr) renderer_.replace_stages(lab::parse_choice(technique).value().make_stages());
  }
  const render::FrameBuffer& draw(const render::Scene& scene, const render::Settings& settings) {
    renderer_.render(scene, settings, frame_);
    return frame_;
  }
  FrameCopy copy(const render::Scene& scene, const render::Settings& settings) {
    return copy_picture(draw(scene, settings));
  }

  static constexpr int kWidth = 333, kHeight = 203;

 private:
  render::Renderer renderer_;
  render::FrameBuffer frame_;
};

}  // namespace temblor::test
