// The project's performance table: what `temblor bench --report` prints, in Markdown.
#pragma once

#include <string>

#include "app/demo/demo_loading.h"
#include "app/files/level_loading.h"
#include "base/result.h"
#include "client/view/presentation.h"
#include "render/renderer.h"

namespace temblor::app {

// Measures one level in all the ways that docs/performance.md reports (minutes), starting from `settings`
// (threads aside), and prints its section on standard output.
void print_report(const std::string& map_name, const LoadedMap& map, const render::Settings& settings,
                  double step_deg);

// The same for a recording, in both formats. Fails where the recording does.
base::Status print_demo_report(const std::string& name, const LoadedDemo& demo,
                               const client::PresentationSettings& presentation,
                               const render::Settings& settings);

// Goals and machine: what the sections are held against. Printed once, before them.
void print_report_header();

}  // namespace temblor::app
