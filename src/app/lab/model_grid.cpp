#include "app/lab/model_grid.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/bench/samples.h"
#include "app/files/system.h"
#include "app/html/html.h"

namespace temblor::app {
namespace {

// Measures the cells of one technique.
class GridRow {
 public:
  GridRow(const LabScenes& scenes, const lab::Choice& choice, const GridOptions& options)
      : scenes_(scenes),
        choice_(choice),
        options_(options),
        settings_(scenes.adapt(options.settings)),
        renderer_(scenes.look().palette, scenes.look().colormap),
        frame_(options.size.width, options.size.height, options.format) {
    renderer_.replace_stages(choice.make_stages());
  }

  std::vector<GridCell> measure() {
    std::vector<GridCell> cells;
    for (const double distance : options_.distances) {
      double expected_ms = 0;
      for (std::size_t i = 0; i < options_.counts.size(); ++i) {
        const int count = options_.counts[i];
        if (i > 0) expected_ms *= static_cast<double>(count) / options_.counts[i - 1];
        cells.push_back(measure_cell(scenes_.models()->with(count, distance), expected_ms));
        if (cells.back().state == GridCell::State::kMeasured) expected_ms = cells.back().ms;
      }
    }
    return cells;
  }

 private:
  // The first frame fills caches. Sprites are drawn again in some of the others.
  GridCell measure_cell(const ModelCrowd& crowd, double expected_ms) {
    constexpr int kMoments = 4;
    constexpr double kEnough_ms = 1000;
    if (expected_ms > 1000 * options_.frame_limit_s) return {GridCell::State::kTooLong, expected_ms};
    if (used_ms_ + expected_ms > 1000 * options_.technique_limit_s)
      return {GridCell::State::kNoTimeLeft, expected_ms};
    std::vector<double> ms;
    double sum_ms = 0;
    bool is_refused = false;
    for (int moment = 0; moment <= kMoments && sum_ms < kEnough_ms && !is_refused; ++moment)
      scenes_.show_crowd(crowd, moment, [&](const render::Scene& scene) {
        is_refused = !choice_.check_scene(scene).ok();
        if (is_refused) return;
        ms.push_back(time_ms([&] { renderer_.render(scene, settings_, frame_); }));
        sum_ms += ms.back();
      });
    used_ms_ += sum_ms;
    if (is_refused) return {GridCell::State::kRefused, 0};
    if (ms.size() > 1) ms.erase(ms.begin());
    std::ranges::nth_element(ms, ms.begin() + static_cast<std::ptrdiff_t>(ms.size() / 2));
    return {GridCell::State::kMeasured, ms[ms.size() / 2]};
  }

  const LabScenes& scenes_;
  const lab::Choice& choice_;
  const GridOptions& options_;
  const render::Settings settings_;
  render::Renderer renderer_;
  render::FrameBuffer frame_;
  double used_ms_ = 0;
};

std::string show_ms(double ms) {
  return fmt::format("{:.{}f}", ms, ms < 1 ? 2 : ms < 10 ? 1 : 0);
}

std::string show_cell(const GridCell& cell) {
  switch (cell.state) {
    case GridCell::State::kMeasured:
      return show_ms(cell.ms);
    case GridCell::State::kTooLong:
      return fmt::format("– ({:.0f} s)", cell.ms / 1000);
    case GridCell::State::kNoTimeLeft:
      return "– (time)";
    case GridCell::State::kRefused:
      break;
  }
  return "– (refused)";
}

}  // namespace

ModelGrid measure_model_grid(const LabScenes& scenes, std::span<const lab::Choice> choices,
                             const GridOptions& options) {
  const double begin_s = clock_s();
  ModelGrid grid{options.distances, options.counts, {}, 0};
  for (const lab::Choice& choice : choices)
    grid.techniques.push_back(GridRow(scenes, choice, options).measure());
  grid.seconds = clock_s() - begin_s;
  return grid;
}

std::string make_grid_section(const ModelGrid& grid, std::span<const lab::Choice> choices) {
  std::string html = fmt::format(
      "<section id=\"grid\">\n<h2>Distance and number</h2>\n<p>Frames in ms, in {:.0f} s. Distances are "
      "units "
      "from the eye to the nearest models. A dash: a frame would take so many seconds, or the technique has "
      "used up its time, or refuses so many models.</p>\n<table>\n<tr><th>distance</th>",
      grid.seconds);
  for (const double distance : grid.distances)
    html += fmt::format("<th class=\"n\" colspan=\"{}\">{}</th>", grid.counts.size(), distance);
  html += "</tr>\n<tr><th>models</th>";
  for (std::size_t i = 0; i < grid.distances.size(); ++i)
    for (const int count : grid.counts) html += fmt::format("<th class=\"n\">{}</th>", count);
  html += "</tr>\n";
  for (std::size_t i = 0; i < grid.techniques.size(); ++i) {
    html += fmt::format("<tr><td>{}</td>", escape_html(choices[i].label()));
    for (const GridCell& cell : grid.techniques[i])
      html += fmt::format("<td class=\"n\">{}</td>", show_cell(cell));
    html += "</tr>\n";
  }
  return html + "</table>\n</section>\n";
}

}  // namespace temblor::app
