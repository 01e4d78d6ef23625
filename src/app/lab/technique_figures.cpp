#include "app/lab/technique_figures.h"

#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <numeric>
#include <thread>

#include "app/bench/measurement_output.h"
#include "base/parallel_for.h"

namespace temblor::app {
namespace {

// The world and opaque brush models alone: the oracle knows nothing else.
render::Scene make_judged_scene(const render::Scene& scene,
                                std::vector<render::BrushModelInstance>& out_brush_models) {
  out_brush_models.clear();
  for (const render::BrushModelInstance& model : scene.brush_models)
    if (model.alpha == 1 && !model.is_additive && !model.color) out_brush_models.push_back(model);
  render::Scene judged;
  judged.level = scene.level;
  judged.camera = scene.camera;
  judged.brush_models = out_brush_models;
  judged.time_s = scene.time_s;
  judged.light_styles = scene.light_styles;
  return judged;
}

FrameSize choose_error_size(const FigureOptions& options) {
  return options.error_size.width > 0 ? options.error_size : options.measure.size;
}

// Draws views with a technique and its counters.
class CountedViews {
 public:
  CountedViews(const assets::Look& look, const lab::Choice& choice, const FigureOptions& options)
      : look_(look),
        options_(options),
        renderer_(look.palette, look.colormap),
        frame_(options.measure.size.width, options.measure.size.height, options.measure.format),
        faces_(frame_.pixel_count()),
        writes_(frame_.pixel_count()),
        light_(choice, choose_error_size(options).width, choose_error_size(options).height),
        texels_(choice, choose_error_size(options).width, choose_error_size(options).height),
        changes_texels_(choice.technique->changes_texels) {
    renderer_.replace_stages(choice.make_stages(&counter_));
  }

  void add(const render::Scene& scene) {
    std::vector<render::BrushModelInstance> brush_models;
    const render::Scene judged = make_judged_scene(scene, brush_models);
    if (!prepared_ || &prepared_->level() != judged.level)
      prepared_ = std::make_unique<oracle::PreparedLevel>(*judged.level);
    render::Settings settings = options_.measure.settings;
    settings.force_mip = 0;
    settings.show = render::Show::kPicture;
    settings.light_view = render::LightView::kLit;
    renderer_.render(judged, settings, frame_);
    count();
    judge(judged, settings.use_pvs);
    render::Scene lit = judged;
    lit.lights = scene.lights;
    light_.add(lit, settings);
    if (!changes_texels_) texels_.add(lit, settings);
  }

  // Counts only: the oracle knows no models.
  void add_models(const render::Scene& scene, const render::Settings& settings) {
    renderer_.render(scene, settings, frame_);
    count();
  }

  ViewFigures means() const {
    ViewFigures means = figures_;
    const double views = static_cast<double>(std::max<std::size_t>(means.views, 1));
    for (double* sum :
         {&means.pixels_written, &means.pixels_tested, &means.comparisons, &means.splits, &means.spans_sorted,
          &means.bytes, &means.planes_tested, &means.cache_hits, &means.portals_clipped,
          &means.leaves_reached, &means.edges_saved, &means.pixels_off, &means.rays})
      *sum /= views;
    means.light = light_.figures();
    means.texels = texels_.figures();
    return means;
  }

 private:
  void count() {
    renderer_.pixel_faces(faces_, writes_);
    const double pixels = static_cast<double>(frame_.pixel_count());
    const lab::Counts counts = counter_.take();
    figures_.pixels_written += std::accumulate(writes_.begin(), writes_.end(), 0.0) / pixels;
    figures_.pixels_tested += static_cast<double>(counts.pixels_tested) / pixels;
    figures_.comparisons += static_cast<double>(counts.comparisons);
    figures_.splits += static_cast<double>(counts.splits);
    figures_.spans_sorted += static_cast<double>(counts.spans_sorted);
    figures_.bytes += static_cast<double>(counts.bytes);
    figures_.cache_hits += static_cast<double>(counts.cache_hits);
    figures_.portals_clipped += static_cast<double>(counts.portals_clipped);
    figures_.leaves_reached += static_cast<double>(counts.leaves_reached);
    figures_.edges_saved += static_cast<double>(counts.edges_saved);
    figures_.planes_tested += static_cast<double>(counts.planes_tested);
    figures_.rays += static_cast<double>(counts.rays) / pixels;
    figures_.pixels_off += static_cast<double>(counts.pixels_off) / pixels;
    figures_.max_texel_error = std::max(figures_.max_texel_error, counts.max_texel_error);
    figures_.stack += counts;
    ++figures_.views;
  }

  // Pixels at equal distances in the order of rows. The distance has no common factor with the width, so they
  // lie in all columns.
  void judge(const render::Scene& scene, bool use_pvs) {
    const oracle::Comparison comparison(*prepared_, scene,
                                        {frame_, faces_, look_.palette, look_.colormap, use_pvs});
    const auto pixels = frame_.pixel_count();
    const auto width = static_cast<std::size_t>(frame_.width());
    std::size_t step = std::max<std::size_t>(pixels / static_cast<std::size_t>(options_.judged_pixels), 1);
    while (std::gcd(step, width) != 1) ++step;
    for (std::size_t i = step / 2; i < pixels; i += step)
      comparison.pixel(static_cast<int>(i % width), static_cast<int>(i / width), figures_.tally);
  }

  const assets::Look& look_;
  const FigureOptions& options_;
  lab::Counter counter_;
  render::Renderer renderer_;
  render::FrameBuffer frame_;
  std::vector<render::PixelFace> faces_;
  std::vector<std::uint8_t> writes_;
  std::unique_ptr<oracle::PreparedLevel> prepared_;
  LightViews light_;
  TexelViews texels_;
  const bool changes_texels_;
  ViewFigures figures_;
};

// Simulated cache misses per triangle.
nlohmann::json make_stack_json(const ViewFigures& views) {
  const lab::Counts& counts = views.stack;
  return {{"loads_per_vertex", views.loads_per_vertex()},
          {"pentium",
           {{"list", views.misses_per_triangle(counts.list_misses)},
            {"stack", views.misses_per_triangle(counts.stack_misses)}}},
          {"today",
           {{"list", views.misses_per_triangle(counts.list_misses_today)},
            {"stack", views.misses_per_triangle(counts.stack_misses_today)}}}};
}

nlohmann::json make_json(const Differences& differences) {
  return {{"mean", differences.mean()}, {"max", differences.largest}};
}

double compute_texels_built(const Measurement& measurement) {
  const auto frames = static_cast<double>(std::max<std::size_t>(measurement.frames, 1));
  return static_cast<double>(measurement.texels_built) / frames;
}

double compute_ratio(const TechniqueFigures& figures, const TechniqueFigures& first) {
  return figures.measurement.frame_ms.p50 / first.measurement.frame_ms.p50;
}

double share_wrong(const oracle::Tally& tally) {
  return tally.pixels == 0 ? 0 : static_cast<double>(tally.wrong_face) / static_cast<double>(tally.pixels);
}

// Appends lines of a table, one column for each technique.
class Table {
 public:
  explicit Table(std::span<const TechniqueFigures> figures) : figures_(figures) {
    for (const TechniqueFigures& column : figures)
      widths_.push_back(std::max<std::size_t>(column.choice.label().size(), 9));
    text_ = fmt::format("{:<24}", "");
    for (std::size_t i = 0; i < figures.size(); ++i)
      text_ += fmt::format("  {:>{}}", figures[i].choice.label(), widths_[i]);
    text_ += "\n";
  }
  // `value` is a function of TechniqueFigures.
  template <typename Value>
  void add(const char* label, int decimals, Value value) {
    text_ += fmt::format("{:<24}", label);
    for (std::size_t i = 0; i < figures_.size(); ++i)
      text_ += fmt::format("  {:>{}.{}f}", value(figures_[i]), widths_[i], decimals);
    text_ += "\n";
  }
  const std::string& text() const { return text_; }

 private:
  std::span<const TechniqueFigures> figures_;
  std::vector<std::size_t> widths_;
  std::string text_;
};

base::Result<ViewFigures> count_views(const LabScenes& scenes, const lab::Choice& choice,
                                      const FigureOptions& options) {
  CountedViews views(scenes.look(), choice, options);
  const render::Settings settings = scenes.adapt(options.measure.settings);
  TRY_STATUS(scenes.for_each_scene([&](const render::Scene& scene) {
    scenes.models() != nullptr ? views.add_models(scene, settings) : views.add(scene);
  }));
  ViewFigures means = views.means();
  if (scenes.models() == nullptr && !choice.technique->draws_models) return means;
  ModelViews models(choice, options.measure.size.width, options.measure.size.height);
  TRY_STATUS(scenes.show_picture_scene(
      [&](const render::Scene& scene) { models.add(scene, options.measure.settings); }));
  means.models = models.errors();
  return means;
}

// Nothing here is timed, so techniques share the processor.
base::Result<std::vector<TechniqueFigures>> count_views(const LabScenes& scenes,
                                                        std::span<const lab::Choice> choices,
                                                        const FigureOptions& options) {
  std::vector<base::Result<ViewFigures>> views(choices.size(), ViewFigures{});
  base::Jobs jobs(static_cast<int>(std::max(1u, std::thread::hardware_concurrency())),
                  base::JobBackend::kStdThread);
  jobs.parallel_for(choices.size(),
                    [&](std::size_t i) { views[i] = count_views(scenes, choices[i], options); });
  std::vector<TechniqueFigures> figures;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    TRY(const ViewFigures of_choice, std::move(views[i]));
    figures.push_back({choices[i], {}, of_choice});
  }
  return figures;
}

}  // namespace

base::Result<std::vector<TechniqueFigures>> find_figures(const LabScenes& scenes,
                                                         std::span<const lab::Choice> choices,
                                                         const FigureOptions& options) {
  TRY(std::vector<TechniqueFigures> figures, count_views(scenes, choices, options));
  MeasureOptions measure = options.measure;
  for (int round = 0; round < options.rounds; ++round)
    for (TechniqueFigures& f : figures) {
      measure.technique = &f.choice;
      TRY(const Measurement measured, scenes.measure(measure));
      if (round == 0 || measured.frame_ms.p50 < f.measurement.frame_ms.p50) f.measurement = measured;
      f.measurement.options.technique = nullptr;  // an element of `figures`, which may move
    }
  return figures;
}

std::string describe_figures(const std::string& name, std::span<const TechniqueFigures> figures) {
  const Measurement& first = figures.front().measurement;
  std::string text =
      fmt::format("{}: {} frames, {}; {} views counted and compared with the oracle\n", name, first.frames,
                  describe_conditions(first.options), figures.front().views.views);
  Table table(figures);
  table.add("frame, ms: median", 3, [](const auto& f) { return f.measurement.frame_ms.p50; });
  table.add("  99th percentile", 3, [](const auto& f) { return f.measurement.frame_ms.p99; });
  table.add("  slowest", 3, [](const auto& f) { return f.measurement.frame_ms.max; });
  table.add("  99th / median", 2,
            [](const auto& f) { return f.measurement.frame_ms.p99 / f.measurement.frame_ms.p50; });
  table.add("  times the first", 2, [&](const auto& f) { return compute_ratio(f, figures.front()); });
  for (std::size_t stage = 0; stage < render::kStages; ++stage) {
    const bool is_zero = std::ranges::all_of(
        figures, [&](const auto& f) { return f.measurement.stage_cycles_per_pixel[stage] < 0.005; });
    if (is_zero) continue;
    table.add(fmt::format("cycles/pixel: {}", render::kStageNames[stage]).c_str(), 2,
              [&](const auto& f) { return f.measurement.stage_cycles_per_pixel[stage]; });
  }
  table.add("faces drawn", 0, [](const auto& f) { return f.measurement.faces_drawn.p50; });
  table.add("edges", 0, [](const auto& f) { return f.measurement.edges.p50; });
  table.add("  not sorted", 0, [](const auto& f) { return f.views.edges_saved; });
  table.add("spans", 0, [](const auto& f) { return f.measurement.spans.p50; });
  table.add("surfaces", 0, [](const auto& f) { return f.measurement.surfaces.p50; });
  table.add("surface cache, MiB", 1,
            [](const auto& f) { return static_cast<double>(f.measurement.cache_bytes) / (1 << 20); });
  table.add("surface texels: median", 0, [](const auto& f) { return f.measurement.texels_read.p50; });
  table.add("  most", 0, [](const auto& f) { return f.measurement.texels_read.max; });
  table.add("  KiB of them", 0, [](const auto& f) {
    const bool indexed = f.measurement.options.format == render::PixelFormat::kIndexed;
    return f.measurement.texels_read.max * (indexed ? 1 : 4) / 1024;
  });
  table.add("  built per frame", 0, [](const auto& f) { return compute_texels_built(f.measurement); });
  table.add("pixels written / pixel", 2, [](const auto& f) { return f.views.pixels_written; });
  table.add("depth tests / pixel", 2, [](const auto& f) { return f.views.pixels_tested; });
  table.add("spans sorted", 0, [](const auto& f) { return f.views.spans_sorted; });
  table.add("comparisons", 0, [](const auto& f) { return f.views.comparisons; });
  table.add("  known from before", 0, [](const auto& f) { return f.views.cache_hits; });
  table.add("splits", 0, [](const auto& f) { return f.views.splits; });
  table.add("planes tested", 0, [](const auto& f) { return f.views.planes_tested; });
  table.add("portals clipped", 0, [](const auto& f) { return f.views.portals_clipped; });
  table.add("leaves reached", 0, [](const auto& f) { return f.views.leaves_reached; });
  table.add("rays / pixel", 2, [](const auto& f) { return f.views.rays; });
  table.add("memory, KiB", 0, [](const auto& f) { return f.views.bytes / 1024; });
  table.add("wrong texels, %", 2, [](const auto& f) { return 100 * f.views.pixels_off; });
  table.add("largest error, texels", 2, [](const auto& f) { return f.views.max_texel_error; });
  table.add("light error, steps: mean", 3, [](const auto& f) { return f.views.light.error.mean(); });
  table.add("  largest", 2, [](const auto& f) { return f.views.light.error.largest; });
  table.add("  at seams, mean", 3, [](const auto& f) { return f.views.light.seams.mean(); });
  table.add("  at shadow edges, mean", 3, [](const auto& f) { return f.views.light.shadow_edges.mean(); });
  table.add("light shift, turn: mean", 3, [](const auto& f) { return f.views.light.turn.mean(); });
  table.add("  largest", 2, [](const auto& f) { return f.views.light.turn.largest; });
  table.add("light shift, roll: mean", 3, [](const auto& f) { return f.views.light.roll.mean(); });
  table.add("  largest", 2, [](const auto& f) { return f.views.light.roll.largest; });
  table.add("texel error: mean", 3, [](const auto& f) { return f.views.texels.error.mean(); });
  table.add("  largest", 2, [](const auto& f) { return f.views.texels.error.largest; });
  table.add("texel shift, turn: mean", 3, [](const auto& f) { return f.views.texels.turn.mean(); });
  table.add("  largest", 2, [](const auto& f) { return f.views.texels.turn.largest; });
  table.add("texel shift, roll: mean", 3, [](const auto& f) { return f.views.texels.roll.mean(); });
  table.add("  largest", 2, [](const auto& f) { return f.views.texels.roll.largest; });
  if (std::ranges::any_of(figures, [](const auto& f) { return f.views.models.covered > 0; })) {
    table.add("models: wrong outline, %", 3,
              [](const auto& f) { return 100 * f.views.models.outline_share(); });
    table.add("  texel error, mean", 3, [](const auto& f) { return f.views.models.mean_texels(); });
    table.add("  above 2 texels, %", 3, [](const auto& f) { return 100 * f.views.models.off_share(); });
  }
  if (std::ranges::any_of(figures, [](const auto& f) { return f.views.stack.vertices > 0; })) {
    const auto add = [&](const char* label, std::uint64_t lab::Counts::*misses) {
      table.add(label, 3, [=](const auto& f) { return f.views.misses_per_triangle(f.views.stack.*misses); });
    };
    table.add("loads / vertex", 3, [](const auto& f) { return f.views.loads_per_vertex(); });
    add("misses / triangle: list", &lab::Counts::list_misses);
    add("  stack", &lab::Counts::stack_misses);
    add("  list, 32 KiB cache", &lab::Counts::list_misses_today);
    add("  stack, 32 KiB cache", &lab::Counts::stack_misses_today);
  }
  table.add("wrong faces, %", 3, [](const auto& f) { return 100 * share_wrong(f.views.tally); });
  return text + table.text();
}

nlohmann::json make_json(const std::string& name, std::span<const TechniqueFigures> figures) {
  const Measurement& first = figures.front().measurement;
  nlohmann::json json = {{first.places == 0 ? "demo" : "map", name},
                         {"size", format_size(first.options.size)},
                         {"color", pixel_format_name(first.options.format)},
                         {"threads", first.options.settings.threads},
                         {"techniques", nlohmann::json::array()}};
  for (const TechniqueFigures& f : figures) {
    const Measurement& m = f.measurement;
    nlohmann::json technique = {{"name", f.choice.technique->name},
                                {"parameters", nlohmann::json::object()},
                                {"frame_ms", make_json(m.frame_ms)},
                                {"ratio", compute_ratio(f, figures.front())},
                                {"faces_drawn", m.faces_drawn.p50},
                                {"edges", m.edges.p50},
                                {"spans", m.spans.p50},
                                {"surfaces_built", m.surfaces_built},
                                {"pixels_written", f.views.pixels_written},
                                {"pixels_tested", f.views.pixels_tested},
                                {"comparisons", f.views.comparisons},
                                {"cache_hits", f.views.cache_hits},
                                {"splits", f.views.splits},
                                {"spans_sorted", f.views.spans_sorted},
                                {"bytes", f.views.bytes},
                                {"edges_saved", f.views.edges_saved},
                                {"planes_tested", f.views.planes_tested},
                                {"portals_clipped", f.views.portals_clipped},
                                {"leaves_reached", f.views.leaves_reached},
                                {"rays", f.views.rays},
                                {"texels_off", f.views.pixels_off},
                                {"max_texel_error", f.views.max_texel_error},
                                {"surface_texels", make_json(m.texels_read)},
                                {"texels_built", compute_texels_built(m)},
                                {"light",
                                 {{"error", make_json(f.views.light.error)},
                                  {"seams", make_json(f.views.light.seams)},
                                  {"shadow_edges", make_json(f.views.light.shadow_edges)},
                                  {"turn", make_json(f.views.light.turn)},
                                  {"roll", make_json(f.views.light.roll)}}},
                                {"texels",
                                 {{"error", make_json(f.views.texels.error)},
                                  {"turn", make_json(f.views.texels.turn)},
                                  {"roll", make_json(f.views.texels.roll)}}},
                                {"models",
                                 {{"outline", f.views.models.outline_share()},
                                  {"texels", f.views.models.mean_texels()},
                                  {"texels_off", f.views.models.off_share()}}},
                                {"stack", make_stack_json(f.views)},
                                {"judged",
                                 {{"pixels", f.views.tally.pixels},
                                  {"wrong", f.views.tally.wrong_face},
                                  {"tied", f.views.tally.tied},
                                  {"near_edge", f.views.tally.near_edge}}}};
    for (std::size_t i = 0; i < f.choice.values.size(); ++i)
      technique["parameters"][std::string(f.choice.technique->parameters[i].name)] = f.choice.values[i];
    for (std::size_t stage = 0; stage < render::kStages; ++stage) {
      technique["stages"][render::kStageNames[stage]] = m.stage_ms[stage];
      technique["cycles_per_pixel"][render::kStageNames[stage]] = m.stage_cycles_per_pixel[stage];
    }
    json["techniques"].push_back(std::move(technique));
  }
  return json;
}

}  // namespace temblor::app
