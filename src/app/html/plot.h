// Plots of measurements as SVG in a page: points or lines on axes, with a legend.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "math/vec.h"

namespace temblor::app {

struct PlotSeries {
  std::string name;
  std::vector<math::Vec2d> points;  // lines connect them in this order
};

enum class Axis { kLinear, kLogarithmic };

// Points that a logarithmic axis cannot show (not above 0) are left out, and so are those that are no finite
// numbers.
struct Plot {
  std::string title, x_label, y_label;
  Axis x_axis = Axis::kLinear, y_axis = Axis::kLinear;
  bool has_lines = true;
  std::vector<PlotSeries> series{};
};

// Colors repeat after kPlotColors series. Linear axes begin at 0.
constexpr std::size_t kPlotColors = 8;
std::string draw_plot(const Plot& plot);

// A file of its own, which needs no style sheet. Several plots are drawn below each other.
std::string draw_svg_file(std::span<const Plot> plots);
inline std::string draw_svg_file(const Plot& plot) {
  return draw_svg_file(std::span(&plot, 1));
}

// For begin_page().
extern const char* const kPlotStyle;

// Marks of an axis that holds [low, high]: 1, 2, or 5 times powers of ten, at most about eight of them.
std::vector<double> choose_ticks(double low, double high, Axis axis);

}  // namespace temblor::app
