#include "app/bench/bench_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <numeric>
#include <thread>

#include "app/bench/measurement.h"
#include "app/bench/measurement_output.h"
#include "app/files/diagnostics.h"
#include "app/files/system.h"

namespace temblor::app {
namespace {

constexpr std::array<render::PixelFormat, 2> kFormats = {render::PixelFormat::kIndexed,
                                                         render::PixelFormat::kRgb};
constexpr FrameSize kMainSize = {1920, 1080};

// Comparisons of sizes and stages need fewer views than the percentiles of single views.
constexpr double kCoarseStepDeg = 30;

// Prints a table row: subject, measured value, goal.
void print_row(const std::string& what, const std::string& measured, const std::string& goal) {
  fmt::print("| {} | {} | {} |\n", what, measured, goal);
  // A report takes minutes, so show each row at once.
  std::fflush(stdout);
}

// Returns the options of most measurements: full size and one thread.
MeasureOptions main_options(const render::Settings& settings, render::PixelFormat format, double step_deg) {
  MeasureOptions options{.size = kMainSize, .format = format, .step_deg = step_deg, .settings = settings};
  options.settings.threads = 1;
  return options;
}

// Prints the main rows of a level in one pixel format: ratio to the baseline, outliers, cold views, light,
// allocations, and the speedup by a second thread.
void report_format(const LoadedMap& map, const render::Settings& settings, render::PixelFormat format,
                   double step_deg) {
  MeasureOptions options = main_options(settings, format, step_deg);
  options.cold = options.relight = true;
  const Measurement one = measure(map, options).value();
  const std::string name = pixel_format_name(format);
  print_row(fmt::format("{}: world view / fill baseline", name),
            fmt::format("{:.2f} ({:.2f} ms, baseline {:.2f} ms, {} views from {} places)",
                        compute_render_baselines(one), one.render_ms.p50, one.baseline_ms.p50, one.frames,
                        one.places),
            "at most 1.2, target 0.9");
  if (format == render::PixelFormat::kIndexed)
    print_row("indexed: present / fill baseline",
              fmt::format("{:.2f} ({:.2f} ms)", compute_present_baselines(one), one.present_ms.p50),
              "at most 0.2");
  print_row(fmt::format("{}: 99th percentile / median", name),
            fmt::format("{:.2f} ({:.2f} ms; max {:.2f} ms)", one.frame_ms.p99 / one.frame_ms.p50,
                        one.frame_ms.p99, one.frame_ms.max),
            "at most 2");
  print_row(fmt::format("{}: cold view / median", name),
            fmt::format("median {:.2f}, 99th percentile {:.2f}", one.cold_ms->p50 / one.render_ms.p50,
                        one.cold_ms->p99 / one.render_ms.p50),
            "at most 4");
  print_row(fmt::format("{}: every surface relit / static, frame rates", name),
            fmt::format("{:.2f} ({:.2f} ms, {:.2f} ms static; half of the surfaces each frame: {:.2f} ms; "
                        "a step of the standard light styles: {:.2f} ms, {:.0f} surfaces)",
                        one.relight->still_ms.p50 / one.relight->relit_ms.p50, one.relight->relit_ms.p50,
                        one.relight->still_ms.p50, one.relight->alternate_ms.p50,
                        one.relight->animated_ms.p50, one.relight->animated_surfaces),
            "at least 0.5");
  print_row(fmt::format("{}: allocations in a warm frame", name), fmt::format("{}", one.max_allocations),
            "0");
  options.cold = options.relight = false;
  options.settings.threads = 2;
  const Measurement two = measure(map, options).value();
  print_row(fmt::format("{}: two threads / one", name),
            fmt::format("{:.2f} (two fill baselines in parallel: {:.2f})",
                        one.render_ms.p50 / two.render_ms.p50, measure_baseline_speedup(kMainSize, format)),
            "at least 1.8 where the baselines reach 2");
  if (format == render::PixelFormat::kIndexed)
    print_row("faces in PVS / drawn / seen (medians)",
              fmt::format("{:.0f} / {:.0f} / {:.0f}", one.faces_in_pvs.p50, one.faces_drawn.p50,
                          one.faces_seen.p50),
              "-");
}

// Formats the share of the client and of every stage in the time of a frame.
std::string describe_shares(const Measurement& m) {
  const double whole_ms = m.client_mean_ms + std::accumulate(m.stage_ms.begin(), m.stage_ms.end(), 0.0);
  std::string text = fmt::format("client {:.0f} %", 100 * m.client_mean_ms / whole_ms);
  for (std::size_t stage = 0; stage < render::kStages; ++stage)
    text += fmt::format(", {} {:.0f} %", render::kStageNames[stage], 100 * m.stage_ms[stage] / whole_ms);
  return text;
}

// Prints the rows of a demo in one pixel format.
base::Status report_demo_format(const LoadedDemo& demo, const client::PresentationSettings& presentation,
                                const render::Settings& settings, render::PixelFormat format) {
  MeasureOptions options = main_options(settings, format, kCoarseStepDeg);
  TRY(const Measurement one, measure_demo(demo, presentation, options));
  for (const std::string& note : one.notes) print_note(note);
  options.settings.threads = 2;
  TRY(const Measurement two, measure_demo(demo, presentation, options));
  const std::string name = pixel_format_name(format);
  print_row(fmt::format("{}: whole frame / fill baseline", name),
            fmt::format("{:.2f} ({:.2f} ms, baseline {:.2f} ms, {} frames)", compute_render_baselines(one),
                        one.render_ms.p50, one.baseline_ms.p50, one.frames),
            "at most 1.4");
  print_row(fmt::format("{}: 99th percentile / fill baseline", name),
            fmt::format("{:.2f} ({:.2f} ms; max {:.2f} ms)", one.render_ms.p99 / one.baseline_ms.p50,
                        one.render_ms.p99, one.render_ms.max),
            "at most 3");
  print_row(fmt::format("{}: two threads / one", name),
            fmt::format("{:.2f} (two fill baselines in parallel: {:.2f})",
                        one.render_ms.p50 / two.render_ms.p50, measure_baseline_speedup(kMainSize, format)),
            "at least 1.8 where the baselines reach 2");
  print_row(fmt::format("{}: frames that allocate", name),
            fmt::format("{} of {}, at most {} times", one.allocating_frames, one.frames, one.max_allocations),
            "only frames that show more than all before");
  print_row(fmt::format("{}: shares", name), describe_shares(one), "-");
  return base::Ok{};
}

// Prints what filling the depth buffer costs, by measuring with and without it.
void report_depth_share(const LoadedMap& map, const render::Settings& settings, double step_deg) {
  for (const render::PixelFormat format : kFormats) {
    MeasureOptions options = main_options(settings, format, std::max(step_deg, kCoarseStepDeg));
    const double with_depth = measure(map, options).value().render_ms.p50;
    options.settings.fill_depth = false;
    const double without = measure(map, options).value().render_ms.p50;
    print_row(fmt::format("{}: share of the time for filling 1/z", pixel_format_name(format)),
              fmt::format("{:.0f} % ({:.2f} ms of {:.2f} ms)", 100 * (1 - without / with_depth),
                          with_depth - without, with_depth),
              "-");
  }
}

// Prints the cost of a pixel for frames from 320x200 to 3840x2160.
void report_sizes(const LoadedMap& map, const render::Settings& settings, double step_deg) {
  constexpr std::array<FrameSize, 5> kSizes = {
      {{320, 200}, {640, 480}, {1280, 720}, {1920, 1080}, {3840, 2160}}};
  constexpr double kNanosecondsPerMs = 1e6;
  for (const render::PixelFormat format : kFormats) {
    MeasureOptions options = main_options(settings, format, std::max(step_deg, kCoarseStepDeg));
    std::string times;
    for (const FrameSize& size : kSizes) {
      options.size = size;
      const double ms = measure(map, options).value().render_ms.p50;
      times += fmt::format("{}{}x{}: {:.2f} ms, {:.2f} ns/pixel", times.empty() ? "" : "; ", size.width,
                           size.height, ms, ms * kNanosecondsPerMs / size.width / size.height);
    }
    print_row(fmt::format("{}: cost by size", pixel_format_name(format)), times,
              "grows no faster than pixels");
  }
}

// Prints the size of the surface cache beside what Michael Abrash's articles about Quake report for it.
void report_surface_cache(const LoadedMap& map, const render::Settings& settings, double step_deg) {
  struct Claim {
    FrameSize size;
    const char* text;
  };
  constexpr std::array<Claim, 2> kClaims = {{{{320, 200}, "article: 600 KB, about 64,000 texels"},
                                             {{640, 480}, "article: a little more than 1 MB"}}};
  constexpr double kKibibyte = 1024.0;
  for (const Claim& claim : kClaims) {
    MeasureOptions options = main_options(settings, render::PixelFormat::kIndexed, step_deg);
    options.size = claim.size;
    options.cold = true;
    options.settings.mip_rule = render::MipRule::kStock;
    const Measurement m = measure(map, options).value();
    print_row(fmt::format("stock mips, {}x{}: texels in a frame's surfaces; cache after a circle",
                          claim.size.width, claim.size.height),
              fmt::format("median {:.0f}, max {:.0f} texels; median {:.0f} KiB, max {:.0f} KiB",
                          m.texels_read.p50, m.texels_read.max, m.circle_cache_bytes->p50 / kKibibyte,
                          m.circle_cache_bytes->max / kKibibyte),
              claim.text);
  }
}

}  // namespace

void print_report_header() {
  fmt::print("Machine: {}, {} threads. {}x{} and one thread unless stated otherwise.\n", processor_name(),
             std::thread::hardware_concurrency(), kMainSize.width, kMainSize.height);
}

void print_report(const std::string& map_name, const LoadedMap& map, const render::Settings& settings,
                  double step_deg) {
  fmt::print("\n### {}\n\n| what | measured | goal |\n| --- | --- | --- |\n", map_name);
  for (const render::PixelFormat format : kFormats) report_format(map, settings, format, step_deg);
  report_depth_share(map, settings, step_deg);
  report_sizes(map, settings, step_deg);
  report_surface_cache(map, settings, step_deg);
}

base::Status print_demo_report(const std::string& name, const LoadedDemo& demo,
                               const client::PresentationSettings& presentation,
                               const render::Settings& settings) {
  fmt::print("\n### {}\n\n| what | measured | goal |\n| --- | --- | --- |\n", name);
  for (const render::PixelFormat format : kFormats)
    TRY_STATUS(report_demo_format(demo, presentation, settings, format));
  return base::Ok{};
}

}  // namespace temblor::app
