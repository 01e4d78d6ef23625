#include "app/bench/allocation_counter.h"
#include "app/bench/fill_baseline.h"
#include "app/bench/measurement.h"
#include "app/bench/samples.h"
#include "app/demo/demo_run.h"
#include "app/files/progress.h"
#include "base/check.h"
#include "base/large_memory.h"
#include "render/present.h"

namespace temblor::app {
namespace {

// The pixels of a window, to measure how long presenting takes. Indexed frames must be expanded to colors;
// rgb frames are shown as they are, so present() does nothing for them.
class Window {
 public:
  Window(const render::FrameBuffer& frame, const MeasureOptions& options)
      : jobs_(options.settings.threads, options.settings.job_backend), options_(options) {
    if (options.format != render::PixelFormat::kIndexed) return;
    pixels_ = base::allocate_large<std::uint32_t>(frame.pixel_count());
    CHECK(pixels_ != nullptr, "no memory for {} pixels", frame.pixel_count());
  }
  void present(const render::FrameBuffer& frame, const formats::Palette& palette) {
    if (pixels_ != nullptr)
      render::present(frame, render::shown_palette(frame, palette), options_.settings.simd_kernels, jobs_,
                      {pixels_.get(), frame.pixel_count()});
  }

 private:
  base::Jobs jobs_;
  const MeasureOptions& options_;
  base::LargeMemory<std::uint32_t> pixels_;
};

struct PlayedDemo {
  Samples samples;
  std::vector<std::string> notes;
};

// Plays the demo once from its beginning with an empty surface cache.
base::Result<PlayedDemo> play_once(const LoadedDemo& demo, const client::PresentationSettings& presentation,
                                   const MeasureOptions& options, Measurement& io_result) {
  TRY(const client::DemoLength length, client::DemoPlayer::scan(demo.bytes, demo.name));
  const FrameOptions frame_options{.size = options.size,
                                   .format = options.format,
                                   .fov_deg = options.fov_deg,
                                   .threads = {},
                                   .renderer = options.renderer};
  TRY(DemoRun run, DemoRun::start(demo, frame_options, presentation, options.settings));
  if (options.technique != nullptr) run.replace_stages(options.technique->make_stages());
  Window window(run.frame(), options);
  const int baseline_placement = options.baseline ? find_fastest_placement(run.frame()) : 0;
  Samples samples;
  samples.reserve(length.packets);
  Progress progress("frames");
  TRY_STATUS(run.warm_up());
  for (bool has_more = true; has_more;) {
    progress.update(samples.frame_ms.size(), length.packets);
    const std::uint64_t allocations_before = allocation_count();
    base::Result<bool> advanced = true;
    const double client_ms = time_ms([&] { advanced = run.advance_by_packet(); });
    if (!advanced.ok()) return advanced.error();
    has_more = *advanced;
    base::Result<render::FrameStats> drawn = render::FrameStats{};
    const double render_ms = time_ms([&] { drawn = run.draw(); });
    if (!drawn.ok()) return drawn.error();
    const render::FrameStats& stats = *drawn;
    const double present_ms = time_ms([&] { window.present(run.frame(), demo.look.palette); });
    io_result.count_allocations(allocation_count() - allocations_before);
    samples.client_ms.push_back(client_ms);
    samples.render_ms.push_back(client_ms + render_ms);
    samples.present_ms.push_back(present_ms);
    samples.frame_ms.push_back(client_ms + render_ms + present_ms);
    if (options.baseline)
      samples.baseline_ms.push_back(time_ms([&] { run_fill_baseline(baseline_placement, run.frame()); }));
    samples.add(stats);
    io_result.surfaces_built += stats.surfaces_built;
    io_result.texels_built += stats.texels_built;
    io_result.cache_bytes = stats.cache_bytes;
  }
  return PlayedDemo{std::move(samples), run.take_notes()};
}

}  // namespace

// Notes and counts are the same in each run, so those of the first count. Each frame's times are those of its
// fastest run.
base::Result<Measurement> measure_demo(const LoadedDemo& demo,
                                       const client::PresentationSettings& presentation,
                                       const MeasureOptions& options) {
  Measurement result;
  result.options = options;
  TRY(PlayedDemo played, play_once(demo, presentation, options, result));
  result.notes = std::move(played.notes);
  for (int i = 1; i < options.runs; ++i) {
    Measurement again;
    TRY(const PlayedDemo other, play_once(demo, presentation, options, again));
    played.samples.keep_fastest(other.samples);
  }
  const auto pixels =
      static_cast<std::size_t>(options.size.width) * static_cast<std::size_t>(options.size.height);
  played.samples.summarize(pixels, result);
  return result;
}

}  // namespace temblor::app
