#include "app/html/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "app/html/html.h"

namespace temblor::app {
namespace {

// In the SVG's units, which are pixels at full size.
constexpr double kWidth = 920, kHeight = 380;
constexpr double kLeft = 70, kRight = 660, kTop = 14, kBottom = 330;

double scale(double value, Axis axis) {
  return axis == Axis::kLogarithmic ? std::log10(value) : value;
}

bool can_show(double value, Axis axis) {
  return std::isfinite(value) && (axis == Axis::kLinear || value > 0);
}

// One axis of a plot: values from `low` to `high` on coordinates from `begin` to `end`.
class AxisScale {
 public:
  AxisScale(Axis axis, double begin, double end) : axis_(axis), begin_(begin), end_(end) {}

  void add(double value) {
    low_ = std::min(low_, value);
    high_ = std::max(high_, value);
  }
  // Call after the last add(). The axis ends at ticks.
  void finish() {
    if (low_ > high_) low_ = high_ = 1;
    if (axis_ == Axis::kLinear) low_ = std::min(low_, 0.0);
    if (low_ == high_) high_ = low_ == 0 ? 1 : low_ * 2;
    ticks_ = choose_ticks(low_, high_, axis_);
    low_ = std::min(low_, ticks_.front());
    high_ = std::max(high_, ticks_.back());
  }
  double place(double value) const {
    const double from = scale(low_, axis_), to = scale(high_, axis_);
    return begin_ + (scale(value, axis_) - from) / (to - from) * (end_ - begin_);
  }
  const std::vector<double>& ticks() const { return ticks_; }

 private:
  Axis axis_;
  double begin_, end_;
  double low_ = std::numeric_limits<double>::max(), high_ = std::numeric_limits<double>::lowest();
  std::vector<double> ticks_;
};

// A different shape for each color, for readers who cannot tell the colors apart.
std::string draw_mark(double x, double y, std::size_t series) {
  constexpr double kSize = 4;
  switch (series % 4) {
    case 0:
      return fmt::format("M{0:.1f} {1:.1f}h{2}v{2}h-{2}z", x - kSize, y - kSize, 2 * kSize);
    case 1:
      return fmt::format("M{0:.1f} {1:.1f}l{2} {3}h-{3}z", x, y - kSize, kSize, 2 * kSize);
    case 2:
      return fmt::format("M{0:.1f} {1:.1f}h{3}l-{2} {3}z", x - kSize, y - kSize, kSize, 2 * kSize);
    default:
      return fmt::format("M{0:.1f} {1:.1f}l{2} {2}l-{2} {2}l-{2} -{2}z", x, y - kSize, kSize);
  }
}

std::string draw_series(const Plot& plot, std::size_t number, const AxisScale& x_axis,
                        const AxisScale& y_axis) {
  std::string line, marks;
  for (const math::Vec2d& point : plot.series[number].points) {
    if (!can_show(point.x, plot.x_axis) || !can_show(point.y, plot.y_axis)) continue;
    const double x = x_axis.place(point.x), y = y_axis.place(point.y);
    line += fmt::format("{}{:.1f} {:.1f}", line.empty() ? "M" : "L", x, y);
    marks += draw_mark(x, y, number);
  }
  std::string svg = fmt::format("<g class=\"s{}\">", number % kPlotColors);
  if (plot.has_lines) svg += fmt::format("<path class=\"line\" d=\"{}\"/>", line);
  const double legend_y = kTop + 10 + 22 * static_cast<double>(number);
  return svg + fmt::format("<path d=\"{}{}\"/></g>\n<text x=\"{}\" y=\"{}\">{}</text>\n", marks,
                           draw_mark(kRight + 22, legend_y, number), kRight + 34, legend_y + 4,
                           escape_html(plot.series[number].name));
}

std::string format_tick(double value) {
  return value >= 1e6 ? fmt::format("{:g} M", value / 1e6) : fmt::format("{:g}", value);
}

std::string draw_axes(const Plot& plot, const AxisScale& x_axis, const AxisScale& y_axis) {
  std::string svg;
  for (const double tick : x_axis.ticks()) {
    const double x = x_axis.place(tick);
    svg += fmt::format(
        "<path class=\"grid\" d=\"M{0:.1f} {1}V{2}\"/><text class=\"mid\" x=\"{0:.1f}\" "
        "y=\"{3}\">{4}</text>\n",
        x, kTop, kBottom, kBottom + 18, format_tick(tick));
  }
  for (const double tick : y_axis.ticks()) {
    const double y = y_axis.place(tick);
    svg += fmt::format(
        "<path class=\"grid\" d=\"M{0} {1:.1f}H{2}\"/><text class=\"end\" x=\"{3}\" "
        "y=\"{4:.1f}\">{5}</text>\n",
        kLeft, y, kRight, kLeft - 8, y + 4, format_tick(tick));
  }
  const double middle_y = (kTop + kBottom) / 2;
  svg += fmt::format("<text class=\"mid\" x=\"{}\" y=\"{}\">{}</text>\n", (kLeft + kRight) / 2, kBottom + 42,
                     escape_html(plot.x_label));
  return svg + fmt::format(
                   "<text class=\"mid\" transform=\"rotate(-90 16 {0})\" x=\"16\" y=\"{0}\">{1}"
                   "</text>\n",
                   middle_y, escape_html(plot.y_label));
}

// Everything inside of the <svg> element.
std::string draw_content(const Plot& plot) {
  AxisScale x_axis(plot.x_axis, kLeft, kRight), y_axis(plot.y_axis, kBottom, kTop);
  for (const PlotSeries& series : plot.series)
    for (const math::Vec2d& point : series.points) {
      if (!can_show(point.x, plot.x_axis) || !can_show(point.y, plot.y_axis)) continue;
      x_axis.add(point.x);
      y_axis.add(point.y);
    }
  x_axis.finish();
  y_axis.finish();
  std::string svg = draw_axes(plot, x_axis, y_axis);
  for (std::size_t i = 0; i < plot.series.size(); ++i) svg += draw_series(plot, i, x_axis, y_axis);
  return svg;
}

}  // namespace

const char* const kPlotStyle = R"(
figure { margin: 1rem 0; }
figcaption { color: var(--soft); font-size: .9rem; }
.plot { width: 100%; display: block; font-size: 13px; }
.plot text { fill: var(--ink); }
.plot .mid { text-anchor: middle; }
.plot .end { text-anchor: end; }
.plot .grid { stroke: var(--line); fill: none; }
.plot .line { fill: none !important; stroke: currentColor; stroke-width: 2px; opacity: .8; }
.plot g path { fill: currentColor; }
.s0 { color: #2f6fc4; } .s1 { color: #d2691e; } .s2 { color: #2d8a4e; } .s3 { color: #b03a72; }
.s4 { color: #7a5cc0; } .s5 { color: #8a7a1f; } .s6 { color: #1f9aa8; } .s7 { color: #7d7d7d; }
)";

std::vector<double> choose_ticks(double low, double high, Axis axis) {
  std::vector<double> ticks;
  constexpr int kMaxSteps = 8;
  if (axis == Axis::kLogarithmic) {
    const double decades = std::log10(high / low);
    for (int power = static_cast<int>(std::floor(std::log10(low))); std::pow(10, power) < high * 10; ++power)
      for (const double digit : {1.0, 2.0, 5.0}) {
        if (digit != 1 && decades > 3) continue;
        ticks.push_back(digit * std::pow(10, power));
      }
    // One below the lowest value and one above the highest are enough.
    while (ticks.size() > 2 && ticks[1] <= low) ticks.erase(ticks.begin());
    while (ticks.size() > 2 && ticks[ticks.size() - 2] >= high) ticks.pop_back();
    return ticks;
  }
  double step = std::pow(10, std::floor(std::log10((high - low) / kMaxSteps)));
  for (const double factor : {2.0, 2.5, 2.0})
    if ((high - low) / step > kMaxSteps) step *= factor;
  const double first = std::floor(low / step);
  for (int i = 0; i == 0 || ticks.back() < high; ++i) ticks.push_back((first + i) * step);
  return ticks;
}

std::string draw_plot(const Plot& plot) {
  return fmt::format(
      "<figure><svg class=\"plot\" viewBox=\"0 0 {} {}\" role=\"img\">\n{}</svg><figcaption>{}"
      "</figcaption></figure>\n",
      kWidth, kHeight, draw_content(plot), escape_html(plot.title));
}

namespace {

// Few viewers of files know the page's variables.
std::string make_file_style() {
  std::string style = kPlotStyle;
  for (const auto& [variable, color] : {std::pair<std::string_view, std::string_view>{"var(--ink)", "#222"},
                                        {"var(--line)", "#ddd"},
                                        {"var(--soft)", "#666"}})
    for (std::size_t at = style.find(variable); at != std::string::npos; at = style.find(variable))
      style.replace(at, variable.size(), color);
  return style;
}

}  // namespace

std::string draw_svg_file(std::span<const Plot> plots) {
  constexpr double kTitleHeight = 30, kPlotHeight = kHeight + kTitleHeight;
  std::string content;
  for (std::size_t i = 0; i < plots.size(); ++i)
    content += fmt::format("<g transform=\"translate(0 {})\">\n{}<text x=\"{}\" y=\"{}\">{}</text></g>\n",
                           kPlotHeight * static_cast<double>(i), draw_content(plots[i]), kLeft,
                           kPlotHeight - 12, escape_html(plots[i].title));
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"plot\" width=\"{0}\" height=\"{1}\" "
      "viewBox=\"0 0 {0} {1}\">\n<style>svg {{ font-family: sans-serif; }}\n{2}</style>\n"
      "<rect width=\"{0}\" height=\"{1}\" fill=\"white\"/>\n{3}</svg>\n",
      kWidth, kPlotHeight * static_cast<double>(plots.size()), make_file_style(), content);
}

}  // namespace temblor::app
