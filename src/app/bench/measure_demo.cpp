#include "app/bench/allocation_counter.h"
#include "app/bench/fill_baseline.h"
#include "app/bench/measurement.h"
#include "app/bench/samples.h"
#include "app/demo/demo_run.h"
#include "app/files/diagnostics.h"
#include "app/files/progress.h"
#include "base/check.h"
#include "base/large_memory.h"

namespace temblor::app {
namespace {

// What a window takes its pixels from, where the frame's have to be turned into colors first.
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
      render::present(frame, palette, options_.settings.vector_kernels, jobs_,
                      {pixels_.get(), frame.pixel_count()});
  }

 private:
  base::Jobs jobs_;
  const MeasureOptions& options_;
  base::LargeMemory<std::uint32_t> pixels_;
};

struct PlayedOnce {
  Samples samples;
  std::vector<std::string> notes;
};

// The recording once, from its beginning, with nothing built.
base::Result<PlayedOnce> play_through(const LoadedDemo& demo,
                                      const client::PresentationSettings& presentation,
                                      const MeasureOptions& options, Measurement& io_result) {
  TRY(const client::DemoLength length, client::DemoPlayer::scan(demo.bytes, demo.name));
  const FrameOptions frame_options{
      .size = options.size, .format = options.format, .fov_deg = options.fov_deg, .threads = {}};
  TRY(DemoRun run, DemoRun::start(demo, frame_options, presentation, options.settings));
  Window window(run.frame(), options);
  const int floor_placement = quickest_floor_placement(run.frame());
  Samples samples;
  samples.reserve(length.packets);
  Progress progress("frames");
  run.draw();  // what is done once for a level is part of loading it
  for (bool goes_on = true; goes_on;) {
    progress.update(samples.frame_ms.size(), length.packets);
    const std::uint64_t allocations_before = allocation_count();
    base::Result<bool> advanced = true;
    const double client_ms = time_ms([&] { advanced = run.advance_by_packet(); });
    if (!advanced.ok()) return advanced.error();
    goes_on = *advanced;
    render::FrameStats stats;
    const double render_ms = time_ms([&] { stats = run.draw(); });
    const double present_ms = time_ms([&] { window.present(run.frame(), demo.look.palette); });
    io_result.count_allocations(allocation_count() - allocations_before);
    samples.client_ms.push_back(client_ms);
    samples.render_ms.push_back(client_ms + render_ms);
    samples.present_ms.push_back(present_ms);
    samples.frame_ms.push_back(client_ms + render_ms + present_ms);
    samples.floor_ms.push_back(time_ms([&] { fill_with_floor_loop(floor_placement, run.frame()); }));
    samples.add(stats);
    io_result.surfaces_built += stats.surfaces_built;
    io_result.cache_bytes = stats.cache_bytes;
  }
  return PlayedOnce{std::move(samples), run.take_notes()};
}

}  // namespace

base::Result<Measurement> measure_demo(const LoadedDemo& demo,
                                       const client::PresentationSettings& presentation,
                                       const MeasureOptions& options) {
  Measurement result;
  result.options = options;
  TRY(PlayedOnce played, play_through(demo, presentation, options, result));
  for (const std::string& note : played.notes) print_note(note);
  for (int i = 1; i < options.runs; ++i) {
    Measurement again;
    TRY(const PlayedOnce other, play_through(demo, presentation, options, again));
    played.samples.keep_quickest(other.samples);
  }
  const auto pixels =
      static_cast<std::size_t>(options.size.width) * static_cast<std::size_t>(options.size.height);
  played.samples.summarize(pixels, result);
  return result;
}

}  // namespace temblor::app
