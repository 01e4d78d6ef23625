// `temblor bench`: how fast levels are drawn, and what each stage costs.
#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

#include "app/options.h"
#include "base/result.h"
#include "render/renderer.h"

namespace temblor::app {

struct BenchOptions {
  std::vector<std::string> maps;  // none: the level made in code
  FrameOptions frame{.size = {1920, 1080}};
  double step_deg = 5;
  bool cold = false;
  bool relight = false;
  bool json = false;
  bool report = false;
};

CLI::App* add_bench_command(CLI::App& program, BenchOptions& io_options);

base::Status run_bench(const BenchOptions& options, const GameFolders& folders,
                       const render::Settings& settings);

}  // namespace temblor::app
