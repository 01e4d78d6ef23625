// How far the models that a technique draws are from their exact picture (lab/exact_models.h).
#pragma once

#include <memory>
#include <unordered_map>

#include "lab/technique.h"
#include "render/frame_buffer.h"
#include "render/renderer.h"

namespace temblor::app {

// Sums over pictures.
struct ModelErrors {
  double covered = 0;     // pixels of the exact picture that show a model
  double outline = 0;     // pixels that show a model in only one of the two pictures
  double compared = 0;    // pixels that show one in both
  double texel_sum = 0;   // over those: the distance of texels along s or t, whichever is larger
  double texels_off = 0;  // of those: texels that are more than kTexelsOff away

  static constexpr double kTexelsOff = 2;
  double outline_share() const { return covered == 0 ? 0 : outline / covered; }
  double mean_texels() const { return compared == 0 ? 0 : texel_sum / compared; }
  double off_share() const { return compared == 0 ? 0 : texels_off / compared; }
};

class ModelViews {
 public:
  ModelViews(const lab::Choice& choice, int width, int height);
  // Compares the models of a scene. Scenes follow one another in time. The first counts only if it is the
  // only one: techniques that reuse earlier pictures have none yet.
  void add(const render::Scene& scene, const render::Settings& settings);
  const ModelErrors& errors() const { return errors_; }

 private:
  struct CodedModels {
    std::shared_ptr<const render::AliasModel> by_axis[2];
  };
  void draw(const render::Scene& scene, const render::Settings& settings, int axis);

  render::Renderer renderers_[2];  // one for each axis, because techniques have a memory
  render::FrameBuffer frames_[2];
  std::unordered_map<const render::AliasModel*, CodedModels> coded_;
  ModelErrors errors_;
  int scenes_ = 0;
};

}  // namespace temblor::app
