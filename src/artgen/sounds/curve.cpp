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

constexpr double kUnknown_s = -1;

// The first is at 0 and the last at the end where they do not say.
void spread_times(std::vector<TimedWord>& io_words, double length_s) {
  if (io_words.front().time_s == kUnknown_s) io_words.front().time_s = 0;
  if (io_words.back().time_s == kUnknown_s) io_words.back().time_s = length_s;
  std::size_t known = 0;
  for (std::size_t i = 1; i < io_words.size(); ++i) {
    if (io_words[i].time_s == kUnknown_s) continue;
    const double step = (io_words[i].time_s - io_words[known].time_s) / static_cast<double>(i - known);
    for (std::size_t j = known + 1; j < i; ++j)
      io_words[j].time_s = io_words[known].time_s + step * static_cast<double>(j - known);
    known = i;
  }
}

std::optional<Curve> curve_in(std::string_view text, const CurveLimits& limits, double length_s) {
  std::vector<Curve::Point> points;
  for (const TimedWord& word : timed_words(text, length_s)) {
    const std::optional<double> value = number_in(word.word);
    if (!value || *value < limits.lowest || *value > limits.highest) return {};
    points.push_back({word.time_s, *value});
  }
  if (points.empty()) return {};
  return Curve(std::move(points), limits.glide);
}

Curve checked_curve(Arguments& io_arguments, std::string_view label, std::string_view text, double otherwise,
                    const CurveLimits& limits, double length_s) {
  if (std::optional<Curve> curve = curve_in(text, limits, length_s)) return *std::move(curve);
  io_arguments.complain(
      fmt::format("{}{} is neither a number nor FROM..TO (a point between with its second: 0..1@0.2..0), all "
                  "from {} to {}",
                  label, base::quotable(text), limits.lowest, limits.highest));
  return Curve({{0, otherwise}}, limits.glide);
}

}  // namespace

std::vector<TimedWord> timed_words(std::string_view text, double length_s) {
  std::vector<TimedWord> words;
  double last_s = 0;
  while (true) {
    const std::size_t end = text.find("..");
    const std::string_view part = text.substr(0, end);
    const std::size_t at = part.find('@');
    TimedWord word{part.substr(0, at), kUnknown_s};
    if (at != std::string_view::npos) {
      const std::optional<double> time_s = number_in(part.substr(at + 1));
      if (!time_s || *time_s < last_s) return {};
      word.time_s = last_s = *time_s;
    }
    if (word.word.empty()) return {};
    words.push_back(word);
    if (end == std::string_view::npos) break;
    text.remove_prefix(end + 2);
  }
  spread_times(words, std::max(length_s, last_s));
  return words;
}

double Curve::at(double time_s) const {
  const auto next =
      std::find_if(points_.begin(), points_.end(), [&](const Point& point) { return point.time_s > time_s; });
  if (next == points_.begin()) return points_.front().value;
  if (next == points_.end()) return points_.back().value;
  const Point& before = *(next - 1);
  const double part = (time_s - before.time_s) / (next->time_s - before.time_s);
  if (glide_ == Glide::kByRatio) return before.value * std::pow(next->value / before.value, part);
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

Curve curve_setting(Arguments& io_arguments, std::string_view name, double otherwise,
                    const CurveLimits& limits, double length_s) {
  const bool given = io_arguments.has(name);
  const std::string text = io_arguments.text(name, "");
  if (!given) return Curve({{0, otherwise}}, limits.glide);
  return checked_curve(io_arguments, fmt::format("{}=", name), text, otherwise, limits, length_s);
}

Curve curve_value(Arguments& io_arguments, double otherwise, const CurveLimits& limits, double length_s) {
  const std::string text = io_arguments.text();
  return checked_curve(io_arguments, "", text, otherwise, limits, length_s);
}

}  // namespace temblor::artgen
