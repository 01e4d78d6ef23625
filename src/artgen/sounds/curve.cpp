#include "artgen/sounds/curve.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "artgen/scripts/script.h"
#include "base/text.h"

namespace temblor::artgen {
namespace {

// Marks points whose time is not given.
constexpr double kUnknown_s = -1;

// Without times, the first point is at 0 and the last one at the end. Unknown times between two known ones
// are spaced evenly.
void fill_in_times(std::vector<TimedText>& io_texts, double length_s) {
  if (io_texts.front().time_s == kUnknown_s) io_texts.front().time_s = 0;
  if (io_texts.back().time_s == kUnknown_s) io_texts.back().time_s = length_s;
  std::size_t known = 0;
  for (std::size_t i = 1; i < io_texts.size(); ++i) {
    if (io_texts[i].time_s == kUnknown_s) continue;
    const double step = (io_texts[i].time_s - io_texts[known].time_s) / static_cast<double>(i - known);
    for (std::size_t j = known + 1; j < i; ++j)
      io_texts[j].time_s = io_texts[known].time_s + step * static_cast<double>(j - known);
    known = i;
  }
}

// Nothing if the text is not a curve or exceeds the limits.
std::optional<Curve> parse_curve(std::string_view text, const CurveLimits& limits, double length_s) {
  std::vector<Curve::Point> points;
  for (const TimedText& part : parse_timed_texts(text, length_s)) {
    const std::optional<double> value = parse_number(part.text);
    if (!value || *value < limits.lowest || *value > limits.highest) return {};
    points.push_back({part.time_s, *value});
  }
  if (points.empty()) return {};
  return Curve(std::move(points), limits.glide);
}

Curve parse_checked_curve(Arguments& io_arguments, std::string_view label, std::string_view text,
                          double fallback, const CurveLimits& limits, double length_s) {
  if (std::optional<Curve> curve = parse_curve(text, limits, length_s)) return *std::move(curve);
  io_arguments.set_error(
      fmt::format("{}{} must be a number or FROM..TO (with a point at 0.2 seconds: 0..1@0.2..0), all "
                  "from {} to {}",
                  label, base::quotable(text), limits.lowest, limits.highest));
  return Curve({{0, fallback}}, limits.glide);
}

}  // namespace

std::vector<TimedText> parse_timed_texts(std::string_view text, double length_s) {
  std::vector<TimedText> texts;
  double last_s = 0;
  while (true) {
    const std::size_t end = text.find("..");
    const std::string_view part = text.substr(0, end);
    const std::size_t at = part.find('@');
    TimedText timed{part.substr(0, at), kUnknown_s};
    if (at != std::string_view::npos) {
      const std::optional<double> time_s = parse_number(part.substr(at + 1));
      if (!time_s || *time_s < last_s) return {};
      timed.time_s = last_s = *time_s;
    }
    if (timed.text.empty()) return {};
    texts.push_back(timed);
    if (end == std::string_view::npos) break;
    text.remove_prefix(end + 2);
  }
  // A time may lie after the end of the voice; the part of the curve up to the end is then heard.
  fill_in_times(texts, std::max(length_s, last_s));
  return texts;
}

double Curve::at(double time_s) const {
  const auto next =
      std::find_if(points_.begin(), points_.end(), [&](const Point& point) { return point.time_s > time_s; });
  if (next == points_.begin()) return points_.front().value;
  if (next == points_.end()) return points_.back().value;
  const Point& before = *(next - 1);
  const double part = (time_s - before.time_s) / (next->time_s - before.time_s);
  if (glide_ == Glide::kExponential) return before.value * std::pow(next->value / before.value, part);
  return before.value + (next->value - before.value) * part;
}

Signal Curve::values(std::size_t count, double rate) const {
  if (points_.size() == 1) return Signal(count, points_.front().value);
  constexpr std::size_t kStep = 16;
  Signal values(count);
  double from = at(0);
  for (std::size_t i = 0; i < count; i += kStep) {
    const double to = at(static_cast<double>(i + kStep) / rate);
    const std::size_t part = std::min(kStep, count - i);
    for (std::size_t j = 0; j < part; ++j)
      values[i + j] = from + (to - from) * static_cast<double>(j) / static_cast<double>(kStep);
    from = to;
  }
  return values;
}

Curve read_curve_setting(Arguments& io_arguments, std::string_view name, double fallback,
                         const CurveLimits& limits, double length_s) {
  const bool given = io_arguments.has(name);
  const std::string text = io_arguments.text(name, "");
  if (!given) return Curve({{0, fallback}}, limits.glide);
  return parse_checked_curve(io_arguments, fmt::format("{}=", name), text, fallback, limits, length_s);
}

Curve read_curve_value(Arguments& io_arguments, double fallback, const CurveLimits& limits, double length_s) {
  const std::string text = io_arguments.text();
  return parse_checked_curve(io_arguments, "", text, fallback, limits, length_s);
}

}  // namespace temblor::artgen
