// `temblor bench`: how fast levels and recordings are drawn, and what each stage costs.
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
  std::vector<std::string> maps;  // none, and no recordings: the level made in code
  std::vector<std::string> demos;
  FrameOptions frame{.size = {1920, 1080}};
  double step_deg = 5;
  int runs = 1;
  bool cold = false;
  bool relight = false;
  bool json = false;
  bool report = false;
};

Command* add_bench_command(Command& program, BenchOptions& io_options);

base::Status run_bench(const BenchOptions& options, const GameFolders& folders,
                       const client::PresentationSettings& presentation, const render::Settings& settings);

}  // namespace temblor::app
