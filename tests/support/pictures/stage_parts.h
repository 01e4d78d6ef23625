// Everything that a single stage of the renderer needs besides its inputs, for tests that call stages
// separately.
#pragma once

#include "render/view/frame_context.h"
#include "support/pictures/some_colors.h"

namespace temblor::test {

// Uses the settings unchanged: `band_rows` must be set for stages that work in bands.
struct StageParts {
  explicit StageParts(const render::Settings& of_stage = {})
      : settings(of_stage), jobs(of_stage.threads, of_stage.job_backend) {}

  // `scene` and `colors` must outlive the context. Results live in `arenas`.
  render::FrameContext context(const render::Scene& scene,
                               render::PixelFormat format = render::PixelFormat::kIndexed,
                               const render::ColorTables& colors = some_tables()) {
    return {scene, settings, format, colors, jobs, arenas};
  }

  render::Settings settings;
  base::Jobs jobs;
  render::FrameArenas arenas;
};

}  // namespace temblor::test
