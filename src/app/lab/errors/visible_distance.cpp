#include "app/lab/errors/visible_distance.h"

#include "app/lab/model_figures.h"
#include "lab/registry.h"

namespace temblor::app {

namespace {

constexpr FrameSize kSize{320, 200};
constexpr int kComparedMoments = 9;
constexpr double kStep_units = 50, kFarthest_units = 1000;
constexpr double kVisibleRatio = 1.5;

double find_mean_error(const LabScenes& models, const char* technique, double distance_units,
                       const render::Settings& settings) {
  ModelViews views(lab::parse_choice(technique).value(), kSize.width, kSize.height);
  const ModelCrowd one = models.models()->with(1, distance_units);
  for (int moment = 0; moment < kComparedMoments; ++moment)
    models.show_crowd(one, moment, [&](const render::Scene& scene) { views.add(scene, settings); });
  return views.errors().mean_texels();
}

}  // namespace

double find_visible_distance(const LabScenes& models, const render::Settings& settings) {
  double distance_units = kFarthest_units;
  for (; distance_units > kStep_units; distance_units -= kStep_units) {
    const double subdivided = find_mean_error(models, "subdivided-models", distance_units, settings);
    const double by_rows = find_mean_error(models, "affine-models:subpixel=0", distance_units, settings);
    if (subdivided >= kVisibleRatio * by_rows) break;
  }
  return distance_units;
}

}  // namespace temblor::app
