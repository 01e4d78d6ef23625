#include "app/lab/lab_scenes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/demo/demo_playback.h"
#include "app/level/viewpoints.h"
#include "base/text.h"
#include "client/demo/demo_player.h"

namespace temblor::app {

base::Result<LabScenes> LabScenes::load_level(const GameFolders& folders, const std::string& map,
                                              const LabCamera& camera, const CrowdOptions& models) {
  LabScenes scenes;
  TRY(scenes.map_, load_map(folders, map));
  const world::Level& level = *scenes.map_->level;
  scenes.name_ = level.name;
  if (models.count > 0) {
    TRY(scenes.models_, ModelCrowd::load(models, folders, *scenes.map_));
    scenes.name_ =
        fmt::format("{}, {} at {} units", scenes.name_,
                    base::counted(static_cast<std::size_t>(models.count), "model"), models.distance);
  }
  scenes.level_scene_ = make_level_scene(scenes.map_->level);
  std::vector<Viewpoint> viewpoints{find_start_viewpoint(level)};
  // The same models stand before each camera.
  if (!camera.position_world && !camera.angles_deg && !scenes.models_)
    std::ranges::copy(list_viewpoints(level), std::back_inserter(viewpoints));
  for (const Viewpoint& viewpoint : viewpoints)
    scenes.cameras_.push_back({.origin_world = camera.position_world.value_or(viewpoint.eye_world),
                               .angles_deg = camera.angles_deg.value_or(viewpoint.angles_deg),
                               .fov_deg = camera.fov_deg});
  return scenes;
}

base::Result<LabScenes> LabScenes::load_demo(const GameFolders& folders, const std::string& demo,
                                             const client::PresentationSettings& presentation) {
  LabScenes scenes;
  TRY(LoadedDemo loaded, app::load_demo(folders, demo));
  scenes.name_ = demo;
  scenes.demo_ = std::make_unique<const LoadedDemo>(std::move(loaded));
  scenes.presentation_ = presentation;
  return scenes;
}

render::Scene LabScenes::see(std::size_t camera) const {
  return make_scene(level_scene_, cameras_[camera], 0.0);
}

void LabScenes::show(std::size_t camera, int moment, Use use) const {
  if (!models_) return use(see(camera));
  show_crowd(*models_, moment, use);
}

void LabScenes::show_crowd(const ModelCrowd& crowd, int moment, Use use) const {
  render::Scene scene = see(0);
  const std::vector<render::AliasInstance> models = crowd.place(scene.camera, moment);
  scene.alias_models = models;
  scene.brush_models = {};
  use(scene);
}

render::Settings LabScenes::adapt(const render::Settings& settings) const {
  render::Settings adapted = settings;
  if (models_) adapted.draw_world = false;
  return adapted;
}

base::Status LabScenes::for_each_scene(Use use) const {
  if (map_) {
    const std::size_t count = std::min(cameras_.size(), kMaxScenes);
    for (std::size_t i = 0; i < count; ++i) show(i * cameras_.size() / count, 0, use);
    return base::Ok{};
  }
  TRY(const client::DemoLength length, client::DemoPlayer::scan(demo_->bytes, demo_->name));
  TRY(DemoPlayback playback, DemoPlayback::open(*demo_, presentation_));
  // Parts of equal length, each with its scene in the middle.
  std::size_t played = 0;
  for (std::size_t i = 0; i < kMaxScenes; ++i) {
    const std::size_t wanted = std::max<std::size_t>(length.packets * (2 * i + 1) / (2 * kMaxScenes), 1);
    bool has_more = true;
    for (; played < wanted && has_more; ++played) {
      TRY(has_more, playback.advance_by_packet());
    }
    if (i > 0 && !has_more) break;
    use(playback.presentation().scene());
  }
  return base::Ok{};
}

base::Status LabScenes::play(double step_deg, base::FunctionRef<bool(const render::Scene&)> use) const {
  if (map_) {
    const int steps = static_cast<int>(std::ceil(360.0 / step_deg));
    // The first camera is among the others too, if there are others.
    for (std::size_t i = cameras_.size() > 1 ? 1 : 0; i < cameras_.size(); ++i)
      for (int step = 0; step < steps; ++step) {
        render::Camera camera = cameras_[i];
        camera.angles_deg.y += static_cast<float>(step_deg * step);
        if (!use(make_scene(level_scene_, camera, 0.0))) return base::Ok{};
      }
    return base::Ok{};
  }
  TRY(DemoPlayback playback, DemoPlayback::open(*demo_, presentation_));
  for (bool has_more = true; has_more;) {
    TRY(has_more, playback.advance_by_packet());
    if (!use(playback.presentation().scene())) break;
  }
  return base::Ok{};
}

base::Status LabScenes::show_picture_scene(Use use) const {
  if (map_) {
    for (int moment = models_ ? 0 : kMomentsBefore; moment <= kMomentsBefore; ++moment) show(0, moment, use);
    return base::Ok{};
  }
  std::size_t number = 0;
  return for_each_scene([&](const render::Scene& scene) {
    if (number++ == kMaxScenes / 2) use(scene);
  });
}

base::Status LabScenes::check(std::span<const lab::Choice> choices) const {
  const auto draws_models = [](const lab::Choice& choice) { return choice.technique->draws_models; };
  const auto has_check = [](const lab::Choice& choice) { return choice.technique->check_level != nullptr; };
  const auto drawer = std::ranges::find_if(choices, draws_models);
  if (drawer == choices.end() && std::ranges::none_of(choices, has_check)) return base::Ok{};
  std::shared_ptr<const world::LevelIdentity> checked;
  bool has_models = false;
  base::Status status = base::Ok{};
  TRY_STATUS(for_each_scene([&](const render::Scene& scene) {
    has_models |= !scene.alias_models.empty();
    for (const lab::Choice& choice : choices)
      if (status.ok()) status = choice.check_scene(scene);
    if (std::exchange(checked, scene.level->identity) == scene.level->identity) return;
    for (const lab::Choice& choice : choices)
      if (status.ok()) status = choice.check_level(*scene.level);
  }));
  if (status.ok() && drawer != choices.end() && !has_models)
    return base::error(base::ErrorCode::kUnsupported,
                       "{} draws models, and {} shows none; add --models N, or choose a demo with --demo",
                       drawer->technique->name, name_);
  return status;
}

base::Result<Measurement> LabScenes::measure(const MeasureOptions& asked) const {
  MeasureOptions options = asked;
  options.baseline = false;
  if (map_) {
    MeasureOptions of_level = options;
    of_level.models = models();
    of_level.settings = adapt(options.settings);
    return app::measure(*map_, of_level);
  }
  return measure_demo(*demo_, presentation_, options);
}

}  // namespace temblor::app
