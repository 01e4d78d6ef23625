// Copies of one alias model that stand in rows before the camera, each turned and posed differently, for the
// laboratory's techniques that draw models.
//
//     o o o o o o        layer 1, shifted by half a place
//      o o o o o         layer 0: rows above each other, as many as the view has room for
//          |
//         eye            distance: from the eye to the middle of the models in layer 0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/commands/options.h"
#include "app/level/level_loading.h"
#include "base/result.h"
#include "render/scene.h"

namespace temblor::app {

struct CrowdOptions {
  int count = 0;          // 0: no models; at most kMaxModels
  double distance = 100;  // units, kMinDistance to kMaxDistance
  // "progs/ogre.mdl", or "ogre". Empty: the first monster or item that the game has; without game data a
  // model that is made in code.
  std::string model;

  static constexpr int kMaxModels = 1000;
  static constexpr double kMinDistance = 3, kMaxDistance = 3000;
};

class ModelCrowd {
 public:
  // Fails if the model is missing or cannot be read.
  static base::Result<ModelCrowd> load(const CrowdOptions& options, const GameFolders& folders,
                                       const LoadedMap& map);

  // The same model in another number, or at another distance.
  ModelCrowd with(int count, double distance) const {
    ModelCrowd crowd = *this;
    crowd.options_.count = count;
    crowd.options_.distance = distance;
    return crowd;
  }

  // The models before a camera. They turn, walk to the side, and change their pose from one moment to the
  // next, which are 1/20 s apart. Valid while the crowd lives.
  std::vector<render::AliasInstance> place(const render::Camera& camera, int moment) const;

  const std::string& model_name() const;
  int count() const { return options_.count; }
  double distance() const { return options_.distance; }

 private:
  ModelCrowd() = default;
  CrowdOptions options_;
  std::shared_ptr<const render::AliasModel> model_;
};

// A lumpy figure of 56 units with 400 triangles and four poses.
formats::Mdl make_lumpy_figure();

}  // namespace temblor::app
