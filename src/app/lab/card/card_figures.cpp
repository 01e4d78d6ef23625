#include "app/lab/card/card_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <nlohmann/json.hpp>
#include <numbers>
#include <utility>

#include "app/bench/measurement_output.h"
#include "app/bench/samples.h"
#include "app/files/progress.h"
#include "app/files/system.h"
#include "app/lab/card/card_methods.h"
#include "platform/egl/offscreen_context.h"
#include "render/renderer.h"
#include "render_gl/gl_renderer.h"

namespace temblor::app {
namespace {

using render_gl::TexelFormat;
using render_gl::WorldMethod;

int largest_difference(std::uint32_t a, std::uint32_t b) {
  int largest = 0;
  for (int shift = 0; shift < 24; shift += 8)
    largest =
        std::max(largest, std::abs(static_cast<int>(a >> shift & 255) - static_cast<int>(b >> shift & 255)));
  return largest;
}

double compute_equal_share(const render::FrameBuffer& a, const render::FrameBuffer& b) {
  std::size_t equal = 0;
  if (a.format() == render::PixelFormat::kIndexed) {
    for (std::size_t i = 0; i < a.pixel_count(); ++i) equal += a.indexed()[i] == b.indexed()[i];
    return static_cast<double>(equal) / static_cast<double>(a.pixel_count());
  }
  for (std::size_t i = 0; i < a.pixel_count(); ++i) equal += largest_difference(a.rgb()[i], b.rgb()[i]) <= 2;
  return static_cast<double>(equal) / static_cast<double>(a.pixel_count());
}

// Caches of indices are for indexed frames.
render::PixelFormat find_format(const CardFigures& figures) {
  return figures.cache.format == TexelFormat::k8Bit ? render::PixelFormat::kIndexed
                                                    : render::PixelFormat::kRgb;
}

// Lights that circle around the eye, a little further in each frame, as rockets and explosions do.
std::vector<render::DynamicLight> make_lights(const render::Scene& scene, int count, std::size_t frame) {
  constexpr double kStep_radians = 0.1, kTurn_radians = 2 * std::numbers::pi;
  constexpr float kDistance = 80, kRadius = 250;
  std::vector<render::DynamicLight> lights(scene.lights.begin(), scene.lights.end());
  for (int i = 0; i < count; ++i) {
    const double angle = static_cast<double>(frame) * kStep_radians + kTurn_radians * i / count;
    const math::Vec3 offset(std::cos(angle), std::sin(angle), 0);
    lights.push_back({.origin_world = scene.camera.origin_world + offset * kDistance, .radius = kRadius});
  }
  return lights;
}

// Draws frames with one cache, and keeps their figures.
class CardRun {
 public:
  CardRun(render_gl::GlRenderer gl, render::Renderer& cpu, const CardFigures& figures,
          const render::Settings& settings, int lights)
      : gl_(std::move(gl)),
        cpu_(cpu),
        settings_(settings),
        lights_(lights),
        gl_frame_(figures.size.width, figures.size.height, find_format(figures)),
        cpu_frame_(figures.size.width, figures.size.height, find_format(figures)) {}

  // The first scene is drawn twice, so that the frames take as long as in the middle of a game.
  base::Status draw(const render::Scene& played) {
    render::Scene scene = played;
    const std::vector<render::DynamicLight> lights = make_lights(played, lights_, frames());
    scene.lights = lights;
    if (frame_ms_.empty()) TRY_STATUS(gl_.render(scene, settings_, gl_frame_));
    base::Status drawn = base::Ok{};
    frame_ms_.push_back(time_ms([&] {
      const auto stats = gl_.render(scene, settings_, gl_frame_);
      if (!stats.ok()) drawn = stats.error();
    }));
    TRY_STATUS(drawn);
    // This is the time of an earlier frame, since nothing waits for the timer.
    if (const std::optional<double> card_s = gl_.card_seconds()) card_ms_.push_back(*card_s * 1000);
    count(gl_.cache_counts());
    // A sample that grows with the logarithm of the frames.
    if (std::has_single_bit(frame_ms_.size())) {
      cpu_.render(scene, settings_, cpu_frame_);
      equal_shares_.push_back(compute_equal_share(gl_frame_, cpu_frame_));
    }
    return base::Ok{};
  }

  std::size_t frames() const { return frame_ms_.size(); }

  void summarize(CardFigures& io_figures) const {
    io_figures.cache_bytes = gl_.cache_bytes();
    io_figures.frames = frames();
    io_figures.frame_ms = compute_distribution(frame_ms_);
    if (!card_ms_.empty()) io_figures.card_ms = compute_distribution(card_ms_);
    const auto mean = [&](double sum) { return frames() == 0 ? 0 : sum / static_cast<double>(frames()); };
    io_figures.hits = mean(hits_);
    io_figures.uploads = mean(uploads_);
    io_figures.evicted = mean(evicted_);
    io_figures.portions = mean(portions_);
    io_figures.bytes_uploaded = mean(bytes_uploaded_);
    io_figures.max_bytes_uploaded = max_bytes_uploaded_;
    io_figures.equal_share = compute_mean(equal_shares_);
  }

 private:
  void count(const render_gl::CacheCounts& counts) {
    hits_ += counts.hits;
    uploads_ += counts.uploads;
    evicted_ += counts.evicted;
    portions_ += counts.portions;
    bytes_uploaded_ += static_cast<double>(counts.bytes_uploaded);
    max_bytes_uploaded_ = std::max(max_bytes_uploaded_, static_cast<double>(counts.bytes_uploaded));
  }

  render_gl::GlRenderer gl_;
  render::Renderer& cpu_;
  const render::Settings& settings_;
  int lights_;
  render::FrameBuffer gl_frame_, cpu_frame_;
  std::vector<double> frame_ms_, card_ms_, equal_shares_;
  double hits_ = 0, uploads_ = 0, evicted_ = 0, portions_ = 0, bytes_uploaded_ = 0, max_bytes_uploaded_ = 0;
};

// When a run ends: after this number of frames, or this time if the number is 0.
struct CardLimit {
  std::size_t frames;
  double seconds;
};

// The parts that all runs share.
struct CardBench {
  const LabScenes& scenes;
  const CardGrid& grid;
  const render::Settings& settings;
  std::function<void*(const char* name)> find_function;
  render::Renderer cpu;
};

base::Status measure_run(CardBench& io_bench, const CardLimit& limit, CardFigures& io_figures) {
  const assets::Look& look = io_bench.scenes.look();
  render_gl::CacheOptions cache = io_figures.cache;
  // The renderer takes a quarter for indices.
  if (cache.format == TexelFormat::k8Bit) cache.bytes *= 4;
  TRY(render_gl::GlRenderer gl,
      render_gl::GlRenderer::make(io_bench.find_function, look.palette, look.colormap, cache));
  gl.set_method(io_figures.method);
  CardRun run(std::move(gl), io_bench.cpu, io_figures, io_bench.settings, io_bench.grid.lights);
  base::Status drawn = base::Ok{};
  const double end_s = clock_s() + limit.seconds;
  TRY_STATUS(io_bench.scenes.play(io_bench.grid.step_deg, [&](const render::Scene& scene) {
    drawn = run.draw(scene);
    return drawn.ok() && (limit.frames > 0 ? run.frames() < limit.frames : clock_s() < end_s);
  }));
  TRY_STATUS(drawn);
  run.summarize(io_figures);
  return base::Ok{};
}

// Fails on machines whose OpenGL does not suffice, which would otherwise fail once for each cache.
base::Result<std::string> describe_driver(const CardBench& bench) {
  const assets::Look& look = bench.scenes.look();
  TRY(const render_gl::GlRenderer gl,
      render_gl::GlRenderer::make(bench.find_function, look.palette, look.colormap));
  return gl.describe();
}

std::string describe_run(const CardFigures& figures) {
  if (figures.method != WorldMethod::kBlocks) return find_card_method(figures.method).name;
  return fmt::format("{} MB, {} bit", figures.cache.bytes >> 20, count_bits(figures.cache.format));
}

// The runs at one size.
std::vector<CardFigures> plan_runs(const CardGrid& grid, FrameSize size) {
  std::vector<CardFigures> runs;
  const auto add = [&](WorldMethod method, const render_gl::CacheOptions& cache) {
    CardFigures figures;
    figures.size = size;
    figures.method = method;
    figures.cache = cache;
    runs.push_back(figures);
  };
  for (const TexelFormat format : {TexelFormat::k32Bit, TexelFormat::k16Bit, TexelFormat::k8Bit})
    for (const std::size_t megabytes : grid.megabytes)
      add(WorldMethod::kBlocks, {.bytes = megabytes << 20, .format = format});
  for (const CardMethod& each : list_card_methods())
    if (each.method != WorldMethod::kBlocks) add(each.method, {});
  return runs;
}

}  // namespace

int count_bits(TexelFormat format) {
  if (format == TexelFormat::k8Bit) return 8;
  return format == TexelFormat::k16Bit ? 16 : 32;
}

base::Result<CardResults> measure_card(const LabScenes& scenes, const CardGrid& grid,
                                       const render::Settings& settings) {
  TRY(const std::unique_ptr<platform::GlContext> context, platform::egl::make_offscreen_context());
  TRY_STATUS(context->make_current());
  CardBench bench{scenes, grid, settings, [&](const char* name) { return context->find_function(name); },
                  render::Renderer(scenes.look().palette, scenes.look().colormap)};
  CardResults results;
  results.name = scenes.name();
  results.lights = grid.lights;
  TRY(results.driver, describe_driver(bench));
  Progress progress("runs");
  for (const FrameSize size : grid.sizes) {
    CardLimit limit{0, grid.seconds};
    std::vector<CardFigures> runs = plan_runs(grid, size);
    for (CardFigures& figures : runs) {
      progress.update(results.runs.size(), grid.sizes.size() * runs.size());
      const base::Status measured = measure_run(bench, limit, figures);
      if (!measured.ok()) figures.problem = measured.error().message();
      if (limit.frames == 0) limit.frames = figures.frames;
      results.runs.push_back(std::move(figures));
    }
  }
  return results;
}

std::string describe_card(const CardResults& results) {
  std::string text =
      fmt::format("{}: surfaces, and light, in the memory of the card\n{}\n", results.name, results.driver);
  if (results.lights > 0) text += fmt::format("with {} lights around the eye\n", results.lights);
  const CardFigures* previous = nullptr;
  for (const CardFigures& f : results.runs) {
    if (previous == nullptr || format_size(previous->size) != format_size(f.size))
      text += fmt::format(
          "\n{}, {} frames\n"
          "                  ms:                             per frame:                             most  "
          "memory  "
          " equal\n"
          "  cache, method   median     p99   worst  card    hits uploads evicted portions     KB     KB     "
          " MB "
          " pixels\n",
          format_size(f.size), f.frames);
    previous = &f;
    if (!f.problem.empty()) {
      text += fmt::format("  {:<15} {}\n", describe_run(f), f.problem);
      continue;
    }
    text += fmt::format(
        "  {:<15}{:>7.2f} {:>7.2f} {:>7.2f} {:>5} {:>7.1f} {:>7.1f} {:>7.1f} {:>8.2f} {:>6.0f} {:>6.0f} "
        "{:>7.1f} "
        "{:>6.2f}%\n",
        describe_run(f), f.frame_ms.p50, f.frame_ms.p99, f.frame_ms.max,
        f.card_ms ? fmt::format("{:.2f}", f.card_ms->p50) : "-", f.hits, f.uploads, f.evicted, f.portions,
        f.bytes_uploaded / 1000, f.max_bytes_uploaded / 1000, static_cast<double>(f.cache_bytes) / (1 << 20),
        100 * f.equal_share);
  }
  return text;
}

nlohmann::json make_card_json(const CardResults& results) {
  nlohmann::json runs = nlohmann::json::array();
  for (const CardFigures& f : results.runs) {
    runs.push_back({{"size", format_size(f.size)},
                    {"method", find_card_method(f.method).name},
                    {"megabytes", f.cache.bytes >> 20},
                    {"bits", count_bits(f.cache.format)}});
    nlohmann::json& run = runs.back();
    if (!f.problem.empty()) {
      run["problem"] = f.problem;
      continue;
    }
    run.update({{"cache_bytes", f.cache_bytes},
                {"frames", f.frames},
                {"frame_ms", make_json(f.frame_ms)},
                {"hits", f.hits},
                {"uploads", f.uploads},
                {"evicted", f.evicted},
                {"portions", f.portions},
                {"bytes_uploaded", f.bytes_uploaded},
                {"max_bytes_uploaded", f.max_bytes_uploaded},
                {"equal_share", f.equal_share}});
    if (f.card_ms) run["card_ms"] = make_json(*f.card_ms);
  }
  return {{"scene", results.name},
          {"driver", results.driver},
          {"lights", results.lights},
          {"runs", std::move(runs)}};
}

}  // namespace temblor::app
