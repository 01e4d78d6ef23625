#include "app/bench/measure_views.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <vector>

#include "app/bench/measurement_output.h"
#include "app/bench/samples.h"
#include "app/level/level_scene.h"
#include "app/level/viewpoints.h"
#include "base/check.h"

namespace temblor::app {
namespace {

// View i looks from viewpoint i, or from the first ones again in another direction.
std::vector<render::Camera> spread_cameras(const world::Level& level, std::size_t count, float fov_deg) {
  const std::vector<Viewpoint> viewpoints = list_viewpoints(level);
  const std::size_t turns = (count + viewpoints.size() - 1) / viewpoints.size();
  std::vector<render::Camera> cameras;
  for (std::size_t i = 0; i < count; ++i) {
    const Viewpoint& viewpoint = viewpoints[i % viewpoints.size()];
    render::Camera& camera = cameras.emplace_back();
    camera.origin_world = viewpoint.eye_world;
    camera.angles_deg = viewpoint.angles_deg;
    camera.angles_deg.y += 360.0f * static_cast<float>(i / viewpoints.size()) / static_cast<float>(turns);
    camera.fov_deg = fov_deg;
  }
  return cameras;
}

}  // namespace

ViewsMeasurement measure_views(const LoadedMap& map, const MeasureOptions& options, std::size_t views) {
  constexpr int kRounds = 50, kWarmRounds = 2;
  CHECK(views >= 1 && views <= std::size_t{kMaxViews}, "{} views", views);
  const LevelScene level_scene = make_level_scene(map.level);
  std::vector<render::Scene> scenes;
  std::vector<render::FrameBuffer> frames;
  for (const render::Camera& camera : spread_cameras(*map.level, views, options.fov_deg)) {
    scenes.push_back(make_scene(level_scene, camera, 0.0));
    frames.emplace_back(options.size.width, options.size.height, options.format);
  }
  std::vector<render::View> drawn;
  for (std::size_t i = 0; i < views; ++i) drawn.push_back({&scenes[i], &frames[i]});
  render::Settings one_thread = options.settings;
  one_thread.threads = 1;
  // Two renderers, because one would start its threads again in each round.
  render::Renderer for_all(map.look.palette, map.look.colormap), for_one(map.look.palette, map.look.colormap);
  std::vector<double> at_once_ms, one_by_one_ms;
  for (int round = -kWarmRounds; round < kRounds; ++round) {
    const double at_once = time_ms([&] { for_all.render_views(drawn, options.settings); });
    const double one_by_one = time_ms([&] {
      for (const render::View& view : drawn) for_one.render(*view.scene, one_thread, *view.frame);
    });
    if (round < 0) continue;
    at_once_ms.push_back(at_once);
    one_by_one_ms.push_back(one_by_one);
  }
  return {options, views, compute_distribution(std::move(at_once_ms)),
          compute_distribution(std::move(one_by_one_ms))};
}

std::string describe_views(const std::string& name, const ViewsMeasurement& m) {
  const auto times = [](const char* label, const Distribution& ms) {
    return fmt::format("  {:<11}{:>9.3f} ms median {:>9.3f} p99 {:>9.3f} max\n", label, ms.p50, ms.p99,
                       ms.max);
  };
  return fmt::format("{}: {} view{}, {}\n", name, m.views, m.views == 1 ? "" : "s",
                     describe_conditions(m.options)) +
         times("at once", m.at_once_ms) + times("one by one", m.one_by_one_ms) +
         fmt::format("  {:<11}{:>9.3f} of the time one by one, with one thread\n", "ratio", m.ratio());
}

nlohmann::json make_views_json(const std::string& name, const ViewsMeasurement& m) {
  return {{"map", name},
          {"views", m.views},
          {"threads", m.options.settings.threads},
          {"size", format_size(m.options.size)},
          {"color", pixel_format_name(m.options.format)},
          {"at_once_ms", make_json(m.at_once_ms)},
          {"one_by_one_ms", make_json(m.one_by_one_ms)},
          {"ratio", m.ratio()}};
}

}  // namespace temblor::app
