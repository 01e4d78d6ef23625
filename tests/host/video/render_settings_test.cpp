#include "host/video/render_settings.h"

#include <gtest/gtest.h>

namespace temblor::host {
namespace {

// Every field of render::Settings has a variable that sets it to the named value.
TEST(RenderSettings, EveryFieldHasAVariable) {
  command::Variables variables;
  const RenderSettings settings(variables);
  render::Settings expected;
  expected.threads = settings.read(variables).threads;  // one per core of this machine
  EXPECT_GE(expected.threads, 1);
  EXPECT_EQ(settings.read(variables), expected);

  const auto set = [&](const char* assignment) {
    const base::Status status = variables.set_assignment(assignment);
    EXPECT_TRUE(status.ok()) << assignment;
  };
  set("r_threads=3");
  expected.threads = 3;
  EXPECT_EQ(settings.read(variables), expected);
  set("r_job_backend=stdthread");
  expected.job_backend = base::JobBackend::kStdThread;
  EXPECT_EQ(settings.read(variables), expected);
  set("r_mip_rule=stock");
  expected.mip_rule = render::MipRule::kStock;
  EXPECT_EQ(settings.read(variables), expected);
  set("r_mip_force=2");
  expected.force_mip = 2;
  EXPECT_EQ(settings.read(variables), expected);
  set("r_perspective=every16");
  expected.perspective = render::Perspective::kEvery16;
  EXPECT_EQ(settings.read(variables), expected);
  set("r_simd=0");
  expected.simd_kernels = false;
  EXPECT_EQ(settings.read(variables), expected);
  set("r_surface_cache=0");
  expected.surface_cache = false;
  EXPECT_EQ(settings.read(variables), expected);
  set("r_cache_mb=0.5");
  expected.cache_bytes = 512 * 1024;
  EXPECT_EQ(settings.read(variables), expected);
  set("r_use_pvs=0");
  expected.use_pvs = false;
  EXPECT_EQ(settings.read(variables), expected);
  set("r_fill_depth=0");
  expected.fill_depth = false;
  EXPECT_EQ(settings.read(variables), expected);
  set("r_colored_light=0");
  expected.colored_light = false;
  set("r_litwater=0");
  expected.lit_liquids = false;
  EXPECT_EQ(settings.read(variables), expected);
  set("r_band_rows=17");
  expected.band_rows = 17;
  EXPECT_EQ(settings.read(variables), expected);
  using render::Show;
  for (const auto& [assignment, show] : {std::pair("r_show=faces", Show::kFaces),
                                         {"r_show=edges", Show::kEdges},
                                         {"r_show=spans", Show::kSpans},
                                         {"r_show=surfaces", Show::kSurfaces},
                                         {"r_show=mips", Show::kMips},
                                         {"r_show=pvs", Show::kPvs},
                                         {"r_show=overdraw", Show::kOverdraw},
                                         {"r_show=depth", Show::kDepth},
                                         {"r_show=picture", Show::kPicture}}) {
    set(assignment);
    expected.show = show;
    EXPECT_EQ(settings.read(variables), expected);
  }
}

}  // namespace
}  // namespace temblor::host
