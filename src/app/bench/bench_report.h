// The tables of docs/performance.md in Markdown, as `temblor bench --report` prints them. Each row has a
// measured value and the goal of the project for it.
#pragma once

#include <string>

#include "app/demo/demo_loading.h"
#include "app/level/level_loading.h"
#include "base/result.h"
#include "client/view/presentation.h"
#include "render/renderer.h"

namespace temblor::app {

// Measures everything that docs/performance.md reports about a level, which takes minutes, and prints its
// section. `settings` is the starting point; the number of threads is set by each measurement.
void print_report(const std::string& map_name, const LoadedMap& map, const render::Settings& settings,
                  double step_deg);

// The same for a demo, in both pixel formats. Returns an error if the demo is damaged.
base::Status print_demo_report(const std::string& name, const LoadedDemo& demo,
                               const client::PresentationSettings& presentation,
                               const render::Settings& settings);

// Prints the machine and the conditions. Call once, before the sections.
void print_report_header();

}  // namespace temblor::app
