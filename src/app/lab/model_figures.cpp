#include "app/lab/model_figures.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "lab/exact_models.h"

namespace temblor::app {
namespace {

// The distance between the shown texel and a position, both modulo 256.
double find_texel_distance(std::uint8_t shown, double exact) {
  const double middle = shown + 0.5;
  return std::abs(std::remainder(middle - exact, 256.0));
}

}  // namespace

ModelViews::ModelViews(const lab::Choice& choice, int width, int height)
    : renderers_{{formats::Palette{}, lab::make_unlit_colormap()},
                 {formats::Palette{}, lab::make_unlit_colormap()}},
      frames_{{width, height, render::PixelFormat::kIndexed},
              {width, height, render::PixelFormat::kIndexed}} {
  for (render::Renderer& renderer : renderers_) renderer.replace_stages(choice.make_stages());
}

void ModelViews::draw(const render::Scene& scene, const render::Settings& settings, int axis) {
  std::vector<render::AliasInstance> models(scene.alias_models.begin(), scene.alias_models.end());
  for (render::AliasInstance& instance : models) {
    if (instance.model == nullptr) continue;
    std::shared_ptr<const render::AliasModel>& coded = coded_[instance.model].by_axis[axis];
    if (coded == nullptr) coded = lab::make_coordinate_model(*instance.model, axis);
    instance.model = coded.get();
    instance.colors.reset();
  }
  render::Scene alone;
  alone.level = scene.level;
  alone.camera = scene.camera;
  alone.alias_models = models;
  render::Settings own = settings;
  own.draw_world = false;
  own.show = render::Show::kPicture;
  renderers_[axis].render(alone, own, frames_[axis]);
}

void ModelViews::add(const render::Scene& scene, const render::Settings& settings) {
  for (const int axis : {0, 1}) draw(scene, settings, axis);
  if (scenes_++ == 1) errors_ = {};
  const std::vector<lab::ModelPixel> exact =
      lab::draw_exact_models(scene, frames_[0].width(), frames_[0].height());
  for (std::size_t i = 0; i < exact.size(); ++i) {
    const bool is_drawn = frames_[0].depth()[i] > 0;
    errors_.covered += exact[i].hit;
    errors_.outline += exact[i].hit != is_drawn;
    if (!exact[i].hit || !is_drawn) continue;
    const double distance = std::max(find_texel_distance(frames_[0].indexed()[i], exact[i].s),
                                     find_texel_distance(frames_[1].indexed()[i], exact[i].t));
    ++errors_.compared;
    errors_.texel_sum += distance;
    errors_.texels_off += distance > ModelErrors::kTexelsOff;
  }
}

}  // namespace temblor::app
