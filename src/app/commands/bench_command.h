// `temblor bench`: measures how fast levels and demos are drawn, and what each stage of a frame costs.
#pragma once

#include <string>
#include <vector>

#include "app/commands/options.h"
#include "base/result.h"
#include "client/view/presentation.h"
#include "render/renderer.h"

namespace temblor::app {

class Command;

struct BenchOptions {
  // Without maps and demos, the small built-in level is measured.
  std::vector<std::string> maps, demos;
  // Each level and demo is measured at all sizes, in this order; empty: one default size. The size in `frame`
  // is not used.
  std::vector<FrameSize> sizes;
  FrameOptions frame{.size = {}};
  // Angle between two views of a circle.
  double step_deg = 5;
  // Runs of each demo; the fastest time of every frame counts.
  int runs = 1;
  // Also measure with an empty surface cache, and with changing light.
  bool cold = false, relight = false;
  // Measure so many views of each level at once instead of one at a time; 0: do not.
  int views = 0;
  // Print JSON instead of text.
  bool json = false;
  // Print the tables of docs/performance.md instead.
  bool report = false;
  // A shell command whose frame rate is compared with ours in this many alternating runs; empty: none.
  std::string against;
  int rounds = 3;
};

Command* add_bench_command(Command& program, BenchOptions& io_options);

// Measures the maps, then the demos, and prints each result when it is done; JSON is printed at the end.
// Errors: a level or demo that cannot be loaded, a damaged demo, or a problem of options.against
// (measure_other_program()).
base::Status run_bench(const BenchOptions& options, const GameFolders& folders,
                       const client::PresentationSettings& presentation, const render::Settings& settings);

}  // namespace temblor::app
