// Frame times of techniques that draw models, over numbers and distances of models: how the cost of each
// grows. Frames that would take too long are not drawn.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/lab/lab_scenes.h"

namespace temblor::app {

struct GridOptions {
  FrameSize size{1280, 720};
  render::PixelFormat format = render::PixelFormat::kRgb;
  render::Settings settings;
  std::vector<double> distances{3, 10, 30, 100, 300};
  std::vector<int> counts{1, 10, 100, 1000};  // in increasing order
  // A frame, and all frames of a technique.
  double frame_limit_s = 10, technique_limit_s = 4;
};

struct GridCell {
  enum class State { kMeasured, kTooLong, kNoTimeLeft, kRefused };
  State state = State::kRefused;
  // The median of a few frames. kTooLong, kNoTimeLeft: expected from fewer models.
  double ms = 0;
};

struct ModelGrid {
  std::vector<double> distances;
  std::vector<int> counts;
  // By technique: distance by distance, a cell for each count.
  std::vector<std::vector<GridCell>> techniques;
  double seconds = 0;  // that all of it took
};

// `scenes` must have models, of which there will be other numbers.
ModelGrid measure_model_grid(const LabScenes& scenes, std::span<const lab::Choice> choices,
                             const GridOptions& options);

// A section of HTML with the times in ms; a dash and the reason where there is none.
std::string make_grid_section(const ModelGrid& grid, std::span<const lab::Choice> choices);

}  // namespace temblor::app
