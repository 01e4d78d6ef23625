#include "app/bench/measurement.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <thread>

#include "app/bench/allocation_counter.h"
#include "app/bench/fill_baseline.h"
#include "app/bench/samples.h"
#include "app/files/progress.h"
#include "app/files/system.h"
#include "app/lab/model_crowd.h"
#include "app/level/level_scene.h"
#include "app/level/scene_drawer.h"
#include "app/level/viewpoints.h"
#include "base/check.h"
#include "base/large_memory.h"
#include "render/present.h"

namespace temblor::app {
namespace {

// Returns the views of one circle, starting with the viewpoint's own direction.
std::vector<render::Camera> make_circle_views(const Viewpoint& viewpoint, float fov_deg, double step_deg) {
  std::vector<render::Camera> views;
  const auto count = static_cast<int>(std::ceil(360.0 / step_deg));
  for (int i = 0; i < count; ++i) {
    render::Camera camera;
    camera.origin_world = viewpoint.eye_world;
    camera.angles_deg = viewpoint.angles_deg;
    camera.angles_deg.y += static_cast<float>(step_deg * i);
    camera.fov_deg = fov_deg;
    views.push_back(camera);
  }
  return views;
}

// Light for relighting: every light style has the same value, and had the other one in the frame before.
struct Lighting {
  std::uint16_t style_value, style_value_before;
  std::uint32_t frame_number;
  bool alternate;
};

// Renderer, frame, and scene, shared by all measurements of a level.
class Bench {
 public:
  static base::Result<Bench> make(const LoadedMap& map, const MeasureOptions& options) {
    TRY(SceneDrawer drawer, SceneDrawer::make(options.renderer, map.look.palette, map.look.colormap));
    return Bench(map, options, std::move(drawer));
  }

  // Places the models that the next frames show.
  void place_models(const render::Camera& camera) {
    if (options_.models != nullptr) models_ = options_.models->place(camera, moment_++);
  }
  render::FrameStats draw(const render::Camera& camera) { return draw(camera, 0.0); }
  // Draws with the light styles of that time. Everything else stays at time 0, so that only light changes.
  render::FrameStats draw(const render::Camera& camera, double light_time_s) {
    render::Scene scene = make_scene(level_scene_, camera, 0.0);
    scene.light_styles = world::compute_light_styles(level_scene_.light_styles, light_time_s);
    scene.alias_models = models_;
    return draw(scene, options_.settings);
  }
  // Draws with given light, as if the frame before had other light.
  render::FrameStats draw_lit(const render::Camera& camera, const Lighting& light) {
    render::Scene scene = make_scene(level_scene_, camera, 0.0);
    scene.light_styles.fill(light.style_value);
    render::SceneLight before;
    before.light_styles.fill(light.style_value_before);
    scene.light_before = &before;
    scene.frame_number = light.frame_number;
    render::Settings settings = options_.settings;
    settings.relight_alternate = light.alternate;
    return draw(scene, settings);
  }
  // The first failure of the card, after which nothing was drawn.
  const base::Status& status() const { return status_; }
  void present_frame() {
    if (window_ != nullptr)
      render::present(frame_, palette_, options_.settings.simd_kernels, jobs_,
                      {window_.get(), frame_.pixel_count()});
  }
  bool has_baseline() const { return options_.baseline; }
  void run_baseline() { run_fill_baseline(baseline_placement_, frame_); }
  // Empties the CPU's surface cache.
  void drop_surfaces() { drawer_.cpu().drop_surfaces(); }
  const std::vector<std::vector<render::Camera>>& circles() const { return circles_; }
  std::size_t pixels() const { return frame_.pixel_count(); }

 private:
  Bench(const LoadedMap& map, const MeasureOptions& options, SceneDrawer drawer)
      : options_(options),
        palette_(map.look.palette),
        level_scene_(make_level_scene(map.level)),
        drawer_(std::move(drawer)),
        frame_(options.size.width, options.size.height, options.format),
        baseline_placement_(options.baseline ? find_fastest_placement(frame_) : 0),
        jobs_(options.settings.threads, options.settings.job_backend) {
    if (options.technique != nullptr) drawer_.cpu().replace_stages(options.technique->make_stages());
    for (const Viewpoint& viewpoint : list_viewpoints(*map.level)) {
      // Models stand before the camera wherever it is.
      if (options.models != nullptr && !circles_.empty()) break;
      circles_.push_back(make_circle_views(viewpoint, options.fov_deg, options.step_deg));
    }
    if (options.format == render::PixelFormat::kIndexed) {
      window_ = base::allocate_large<std::uint32_t>(frame_.pixel_count());
      CHECK(window_ != nullptr, "no memory for {} pixels", frame_.pixel_count());
    }
  }

  render::FrameStats draw(const render::Scene& scene, const render::Settings& settings) {
    if (!status_) return {};
    base::Result<render::FrameStats> drawn = drawer_.draw(scene, settings, frame_);
    if (drawn.ok()) return *drawn;
    status_ = drawn.error();
    return {};
  }

  const MeasureOptions& options_;
  const formats::Palette& palette_;
  LevelScene level_scene_;
  std::vector<render::AliasInstance> models_;
  int moment_ = 0;
  SceneDrawer drawer_;
  base::Status status_ = base::Ok{};
  render::FrameBuffer frame_;
  int baseline_placement_;
  base::Jobs jobs_;
  // Pixels of a window; null for rgb, which needs no palette expansion.
  base::LargeMemory<std::uint32_t> window_;
  std::vector<std::vector<render::Camera>> circles_;
};

// Measures views with an empty surface cache, and the size of the cache after a circle.
void measure_cold(Bench& io_bench, Measurement& io_result) {
  constexpr std::size_t kDirections = 4;
  Progress progress("cold places");
  std::vector<double> cold_ms, circle_bytes;
  // Do the work that happens once per level.
  io_bench.draw(io_bench.circles().front().front());
  for (const auto& circle : io_bench.circles()) {
    progress.update(circle_bytes.size(), io_bench.circles().size());
    for (std::size_t i = 0; i < kDirections; ++i) {
      const render::Camera& camera = circle[i * circle.size() / kDirections];
      io_bench.drop_surfaces();
      cold_ms.push_back(time_ms([&] { io_bench.draw(camera); }));
    }
    render::FrameStats last;
    for (const render::Camera& camera : circle) last = io_bench.draw(camera);
    circle_bytes.push_back(static_cast<double>(last.cache_bytes));
  }
  io_result.cold_ms = compute_distribution(std::move(cold_ms));
  io_result.circle_cache_bytes = compute_distribution(std::move(circle_bytes));
}

// For four views of each place: ten frames in which all light changes, each followed by one with the same
// light; ten with alternating halves; and ten with the standard light styles.
RelightTimes measure_relight(Bench& io_bench) {
  constexpr std::size_t kDirections = 4, kFrames = 10;
  constexpr double kStyleStep_s = 0.1;
  std::vector<double> still_ms, relit_ms, alternate_ms, animated_ms;
  RelightTimes result;
  const auto time_lit = [&](const render::Camera& camera, const Lighting& light) {
    return time_ms([&] { io_bench.draw_lit(camera, light); });
  };
  // Values of 256 and more: 'm' is normal light in light styles, and each letter above adds 22.
  const auto style_value = [](std::uint32_t frame) {
    return static_cast<std::uint16_t>(256 + 22 * (frame % 5));
  };
  Progress progress("relit places");
  for (std::size_t place = 0; place < io_bench.circles().size(); ++place) {
    progress.update(place, io_bench.circles().size());
    const auto& circle = io_bench.circles()[place];
    for (std::size_t i = 0; i < kDirections; ++i) {
      const render::Camera& camera = circle[i * circle.size() / kDirections];
      const auto lighting = [&](std::uint32_t frame, bool alternate) {
        return Lighting{style_value(frame), style_value(frame + 4), frame, alternate};
      };
      // The first frames of each kind build their surfaces and do not count.
      for (std::uint32_t frame = 0; frame < kFrames; ++frame) {
        const double ms = time_lit(camera, lighting(frame, false));
        const double ms_again = time_lit(camera, lighting(frame, false));
        if (frame == 0) continue;
        relit_ms.push_back(ms);
        still_ms.push_back(ms_again);
      }
      for (std::uint32_t frame = 0; frame < kFrames; ++frame) {
        const double ms = time_lit(camera, lighting(frame, true));
        if (frame > 1) alternate_ms.push_back(ms);
      }
      for (std::uint32_t frame = 0; frame < kFrames; ++frame) {
        render::FrameStats stats;
        const double ms = time_ms([&] { stats = io_bench.draw(camera, frame * kStyleStep_s); });
        if (frame == 0) continue;
        animated_ms.push_back(ms);
        result.animated_surfaces += stats.surfaces_built;
        result.animated_texels += static_cast<double>(stats.texels_built);
      }
    }
  }
  const auto frames = static_cast<double>(animated_ms.size());
  result.animated_surfaces /= frames;
  result.animated_texels /= frames;
  result.still_ms = compute_distribution(std::move(still_ms));
  result.relit_ms = compute_distribution(std::move(relit_ms));
  result.alternate_ms = compute_distribution(std::move(alternate_ms));
  result.animated_ms = compute_distribution(std::move(animated_ms));
  return result;
}

// Draws every view once to fill the caches, then again with the clock running. After `limit_s` (0: none), the
// other circles are left out.
Samples measure_warm(Bench& io_bench, double limit_s, Measurement& io_result) {
  Samples samples;
  std::size_t views = 0, filled = 0;
  const double begin_s = clock_s();
  for (const auto& circle : io_bench.circles()) {
    if (limit_s > 0 && filled > 0 && clock_s() - begin_s > limit_s) break;
    ++filled;
    for (const render::Camera& camera : circle) {
      io_bench.place_models(camera);
      io_bench.draw(camera);
    }
    views += circle.size();
  }
  samples.reserve(views);
  Progress progress("warm views");
  for (const auto& circle : std::span(io_bench.circles()).first(filled)) {
    progress.update(samples.frame_ms.size(), views);
    for (const render::Camera& camera : circle) {
      render::FrameStats stats;
      io_bench.place_models(camera);
      const std::uint64_t allocations_before = allocation_count();
      const double render_ms = time_ms([&] { stats = io_bench.draw(camera); });
      const double present_ms = time_ms([&] { io_bench.present_frame(); });
      const std::uint64_t allocations = allocation_count() - allocations_before;
      io_result.count_allocations(allocations);
      samples.render_ms.push_back(render_ms);
      samples.present_ms.push_back(present_ms);
      samples.frame_ms.push_back(render_ms + present_ms);
      if (io_bench.has_baseline()) samples.baseline_ms.push_back(time_ms([&] { io_bench.run_baseline(); }));
      samples.add(stats);
      io_result.surfaces_built += stats.surfaces_built;
      io_result.texels_built += stats.texels_built;
      io_result.cache_bytes = stats.cache_bytes;
    }
  }
  return samples;
}

}  // namespace

void Measurement::count_allocations(std::uint64_t count) {
  max_allocations = std::max(max_allocations, count);
  allocating_frames += count > 0;
}

// The cold views come first, before the caches are filled for the warm ones. The order does not matter
// otherwise.
base::Result<Measurement> measure(const LoadedMap& map, const MeasureOptions& options) {
  TRY(Bench bench, Bench::make(map, options));
  Measurement result;
  result.options = options;
  result.places = bench.circles().size();
  if (options.cold) measure_cold(bench, result);
  if (options.relight) result.relight = measure_relight(bench);
  const Samples samples = measure_warm(bench, options.time_limit_s, result);
  TRY_STATUS(bench.status());
  samples.summarize(bench.pixels(), result);
  return result;
}

// Alternates between one thread and two, so that a change of the clock frequency affects both.
double measure_baseline_speedup(FrameSize size, render::PixelFormat format) {
  constexpr int kRounds = 20;
  // Long enough that the start of a thread does not matter.
  constexpr int kFillsPerRound = 8;
  render::FrameBuffer first(size.width, size.height, format), second(size.width, size.height, format);
  const int placement = find_fastest_placement(first);
  const auto fill = [placement](render::FrameBuffer& frame) {
    for (int i = 0; i < kFillsPerRound; ++i) run_fill_baseline(placement, frame);
  };
  // Touch its pages before the clock runs, so that page faults are not measured.
  fill(second);
  std::vector<double> alone_ms, together_ms;
  for (int round = 0; round < kRounds; ++round) {
    alone_ms.push_back(time_ms([&] { fill(first); }));
    together_ms.push_back(time_ms([&] {
      std::thread other([&] { fill(second); });
      fill(first);
      other.join();
    }));
  }
  return 2.0 * compute_distribution(alone_ms).p50 / compute_distribution(together_ms).p50;
}

}  // namespace temblor::app
