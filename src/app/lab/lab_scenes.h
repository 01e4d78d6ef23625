// The scenes that the laboratory compares techniques on: views of a level, or moments of a demo.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/bench/measurement.h"
#include "app/demo/demo_loading.h"
#include "app/lab/model_crowd.h"
#include "app/level/level_loading.h"
#include "app/level/level_scene.h"
#include "base/function_ref.h"
#include "base/result.h"
#include "client/view/presentation.h"
#include "lab/technique.h"

namespace temblor::app {

// A camera that the user chose. Nothing: that of the level's first viewpoint.
struct LabCamera {
  std::optional<math::Vec3> position_world, angles_deg;
  float fov_deg = 90;
};

// A level or a demo.
class LabScenes {
 public:
  // `map` may be empty for the small built-in level. With models, scenes show those alone: walls would hide
  // them.
  static base::Result<LabScenes> load_level(const GameFolders& folders, const std::string& map,
                                            const LabCamera& camera, const CrowdOptions& models = {});
  static base::Result<LabScenes> load_demo(const GameFolders& folders, const std::string& demo,
                                           const client::PresentationSettings& presentation);

  const std::string& name() const { return name_; }
  const assets::Look& look() const { return demo_ ? demo_->look : map_->look; }
  // Tolerated problems of the level, one line each.
  std::vector<std::string> notes() const { return map_ ? map_->notes : std::vector<std::string>{}; }
  // Null: none.
  const ModelCrowd* models() const { return models_ ? &*models_ : nullptr; }
  // `settings`, as far as the scenes allow.
  render::Settings adapt(const render::Settings& settings) const;

  // Calls `use` for up to kMaxScenes scenes: the chosen camera, or viewpoints of the level, or moments of the
  // demo. Scenes are valid during the call.
  static constexpr std::size_t kMaxScenes = 8;
  using Use = base::FunctionRef<void(const render::Scene&)>;
  base::Status for_each_scene(Use use) const;
  // Calls `use` for views or moments in their order, until it returns false: full circles at the viewpoints
  // of the level, with `step_deg` between two views, or the packets of the demo.
  base::Status play(double step_deg, base::FunctionRef<bool(const render::Scene&)> use) const;
  // Calls `use` for the scene of the picture: the chosen camera, or the start, or the middle of the demo. If
  // the scene has models before the camera, it is preceded by kMomentsBefore earlier moments, because
  // techniques may reuse pictures of models.
  static constexpr int kMomentsBefore = 4;
  base::Status show_picture_scene(Use use) const;
  // Calls `use` for the first camera with other models before it.
  void show_crowd(const ModelCrowd& crowd, int moment, Use use) const;
  // The scenes that pictures may be chosen from, in the order in which they must be drawn.
  base::Status for_each_picture(Use use) const {
    return models_ ? show_picture_scene(use) : for_each_scene(use);
  }

  // Fails if one of the techniques cannot draw the level, or a level or scene of the demo, or if it draws
  // models and there are none.
  base::Status check(std::span<const lab::Choice> choices) const;

  // Measures circles at all viewpoints, or the whole demo.
  base::Result<Measurement> measure(const MeasureOptions& options) const;

 private:
  LabScenes() = default;
  render::Scene see(std::size_t camera) const;
  // With the models of a moment.
  void show(std::size_t camera, int moment, Use use) const;

  std::string name_;
  // A level.
  std::optional<LoadedMap> map_;
  LevelScene level_scene_;
  std::vector<render::Camera> cameras_;
  std::optional<ModelCrowd> models_;
  // Or a demo.
  std::unique_ptr<const LoadedDemo> demo_;
  client::PresentationSettings presentation_;
};

}  // namespace temblor::app
