// Everything that `temblor lab book` measures, before it writes the pages.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/lab/card/card_figures.h"
#include "app/lab/engine_figures.h"
#include "app/lab/lab_scenes.h"
#include "app/lab/model_grid.h"
#include "app/lab/technique_figures.h"
#include "app/lab/wire/wire_figures.h"
#include "base/result.h"

namespace temblor::app {

struct BookOptions {
  FrameSize size{1280, 720};
  render::PixelFormat format = render::PixelFormat::kRgb;
  render::Settings settings;
  // Angle between two measured views of a level.
  double step_deg = 90;
  // The sizes of the plot of cost against resolution.
  std::vector<FrameSize> sizes{{320, 200}, {640, 400}, {1280, 720}, {1920, 1080}};
  // Distances, numbers, and limits; the rest is as above.
  GridOptions grid;
  // Frames on graphics cards.
  CardGrid card{.sizes = {{320, 200}, {640, 480}}, .megabytes = {2, 4, 64}, .seconds = 0.4};
};

// The figures of all techniques in one level.
struct LevelFigures {
  std::string name;
  std::vector<TechniqueFigures> techniques;
  // By technique: the number of the scene (LabScenes::for_each_scene) where it differs most from the engine,
  // and the share of pixels that differ there.
  std::vector<std::size_t> picture_scenes;
  std::vector<double> different_shares;
};

// The frame times of all techniques in one view.
struct ViewTimes {
  double faces;  // in the engine's edge list, or triangles of the models in view
  std::vector<double> ms;
};

// The median frame times of all techniques in the first level.
struct SizeTimes {
  FrameSize size;
  std::vector<double> ms;
};

struct BookFigures {
  std::vector<lab::Choice> choices;  // the first is the engine
  std::vector<LevelFigures> levels;
  std::vector<ViewTimes> views;
  std::vector<SizeTimes> sizes;
  EngineFigures engine;
  ModelGrid grid;                     // of models; may be empty
  double visible_distance_units = 0;  // of models: errors/visible_distance.h; 0: not measured
  WireResults wire;                   // of the articles' numbers; without freezes: not measured
  double seconds = 0;                 // that all of it took
};

// Measures the techniques in each level. There must be at least one of both.
base::Result<BookFigures> measure_book(std::span<const LabScenes> levels, std::vector<lab::Choice> choices,
                                       const BookOptions& options);

}  // namespace temblor::app
