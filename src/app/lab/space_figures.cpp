#include "app/lab/space_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "app/bench/distribution.h"
#include "app/bench/measurement_output.h"
#include "app/files/system.h"

namespace temblor::app {
namespace {

using lab::space::Battle;
using lab::space::BattleCounts;
using lab::space::BattleShapes;
using lab::space::DepthSorting;

constexpr int kWarmFrames = 3, kMinFrames = 3, kMaxFrames = 100, kRounds = 3;
constexpr double kRoundSeconds = 0.08, kFrameSeconds = 1 / 30.0;

double find_median(std::vector<double>& values) {
  return compute_distribution(std::move(values)).p50;
}

// Draws frames of a battle, and keeps their figures.
class SpaceMeter {
 public:
  explicit SpaceMeter(const SpaceScene& scene)
      : battle_(scene.battle),
        view_(make_lookout_view(battle_, scene)),
        picture_(static_cast<std::size_t>(scene.size.width) * static_cast<std::size_t>(scene.size.height)) {
    for (int i = 0; i < kWarmFrames; ++i) battle_.draw(view_, 0, picture_);
  }

  // Returns the median of a frame's milliseconds.
  double measure_round() {
    std::vector<double> ms;
    const double began_s = clock_s();
    for (int frame = 0; frame < kMaxFrames; ++frame) {
      const double before_s = clock_s();
      if (frame >= kMinFrames && before_s - began_s > kRoundSeconds) break;
      const BattleCounts counts = battle_.draw(view_, frame * kFrameSeconds, picture_);
      ms.push_back((clock_s() - before_s) * 1000);
      edges_.push_back(static_cast<double>(counts.edges));
      surfaces_.push_back(static_cast<double>(counts.surfaces));
      spans_.push_back(static_cast<double>(counts.spans));
      comparisons_.push_back(static_cast<double>(counts.comparisons));
    }
    return find_median(ms);
  }
  // Forgets the frames.
  SpaceFigures finish(double ms) {
    return {.solids = battle_.formation().slots.size(),
            .ms = ms,
            .edges = find_median(edges_),
            .surfaces = find_median(surfaces_),
            .spans = find_median(spans_),
            .comparisons = find_median(comparisons_),
            .depth_complexity = battle_.measure_depth_complexity(view_, 0)};
  }

 private:
  Battle battle_;
  lab::space::BattleView view_;
  std::vector<std::uint32_t> picture_;
  std::vector<double> edges_, surfaces_, spans_, comparisons_;
};

SpaceFigures measure_battle(const SpaceScene& scene) {
  SpaceMeter meter(scene);
  double ms = meter.measure_round();
  for (int round = 1; round < kRounds; ++round) ms = std::min(ms, meter.measure_round());
  return meter.finish(ms);
}

}  // namespace

lab::space::BattleView make_lookout_view(const Battle& battle, const SpaceScene& scene) {
  return lab::space::make_battle_view(battle.lookout(), battle.lookout_axes(), scene.fov_deg,
                                      scene.size.width, scene.size.height);
}

render::FrameBuffer draw_space(const SpaceScene& scene) {
  Battle battle(scene.battle);
  render::FrameBuffer frame(scene.size.width, scene.size.height, render::PixelFormat::kRgb);
  battle.draw(make_lookout_view(battle, scene), 0, frame.rgb());
  return frame;
}

std::vector<SpaceFigures> measure_space(const SpaceScene& scene, std::span<const std::size_t> solids) {
  std::vector<SpaceFigures> figures;
  for (const std::size_t count : solids) {
    SpaceScene measured = scene;
    measured.battle.solids = count;
    figures.push_back(measure_battle(measured));
  }
  return figures;
}

const char* shapes_name(BattleShapes shapes) {
  switch (shapes) {
    case BattleShapes::kConvex:
      return "convex";
    case BattleShapes::kConcave:
      return "concave";
    case BattleShapes::kBoth:
      break;
  }
  return "both";
}

const char* sorting_name(DepthSorting sorting) {
  switch (sorting) {
    case DepthSorting::kIndependent:
      return "independent";
    case DepthSorting::kAbutting:
      return "abutting";
    case DepthSorting::kIntersecting:
      break;
  }
  return "intersecting";
}

std::string make_space_json(const SpaceScene& scene, std::span<const SpaceFigures> figures) {
  nlohmann::json list = nlohmann::json::array();
  for (const SpaceFigures& measured : figures)
    list.push_back({{"solids", measured.solids},
                    {"frame_ms", measured.ms},
                    {"edges", measured.edges},
                    {"surfaces", measured.surfaces},
                    {"spans", measured.spans},
                    {"comparisons", measured.comparisons},
                    {"ns_per_edge", measured.ns_per_edge()},
                    {"depth_complexity", measured.depth_complexity}});
  const nlohmann::json result = {{"scene", "space"},
                                 {"shape", shapes_name(scene.battle.shapes)},
                                 {"sorting", sorting_name(scene.battle.sorting)},
                                 {"spacing", scene.battle.spacing},
                                 {"size", format_size(scene.size)},
                                 {"threads", 1},
                                 {"figures", std::move(list)}};
  return result.dump(2);
}

std::vector<SpaceCurve> measure_space_curves(SpaceScene scene) {
  constexpr std::array<std::size_t, 7> kCounts = {10, 30, 100, 300, 1000, 3000, lab::space::kMaxSolids};
  std::vector<SpaceCurve> curves;
  for (const BattleShapes shapes : {BattleShapes::kConvex, BattleShapes::kConcave}) {
    scene.battle.shapes = shapes;
    curves.push_back({shapes, measure_space(scene, kCounts)});
  }
  return curves;
}

Plot plot_space_curves(const SpaceScene& scene, std::span<const SpaceCurve> curves) {
  Plot plot{.title = fmt::format("The space battle's cost against its solids, at {}, on one thread.",
                                 format_size(scene.size)),
            .x_label = "solids",
            .y_label = "frame, ms",
            .x_axis = Axis::kLogarithmic,
            .y_axis = Axis::kLogarithmic};
  for (const SpaceCurve& curve : curves) {
    PlotSeries series{shapes_name(curve.shapes), {}};
    for (const SpaceFigures& measured : curve.figures)
      series.points.push_back({static_cast<double>(measured.solids), measured.ms});
    plot.series.push_back(std::move(series));
  }
  return plot;
}

}  // namespace temblor::app
