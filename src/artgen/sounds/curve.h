// Values that change during a sound, as scripts write them:
//
//   440             constant
//   440..110        from the start of the voice to its end
//   0..1@0.05..0    by way of 1, which is reached after 0.05 s
//
// Points without a time are spaced evenly between points with one.
#pragma once

#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

#include "artgen/scripts/script.h"
#include "artgen/sounds/signal.h"

namespace temblor::artgen {

// How values change between two points. kLinear: by the same amount each second. kExponential: by the same
// factor each second, which is how pitch is heard; all values must then be above 0.
enum class Glide { kLinear, kExponential };

// A function of time, given by points.
class Curve {
 public:
  struct Point {
    double time_s = 0, value = 0;
  };

  // `points` must not be empty, and their times must not decrease.
  Curve(std::vector<Point> points, Glide glide) : points_(std::move(points)), glide_(glide) {}

  // Multiplies all values.
  void scale(double factor) {
    for (Point& point : points_) point.value *= factor;
  }
  // The value at a time. Before the first point and after the last one it is constant.
  double at(double time_s) const;
  // The values at `count` times that are 1 / rate apart. Only every sixteenth is computed; the others are
  // interpolated linearly.
  Signal values(std::size_t count, double rate) const;

 private:
  // By time, at least one.
  std::vector<Point> points_;
  Glide glide_;
};

// The valid values of a curve, and how it is interpolated.
struct CurveLimits {
  double lowest = 0, highest = 1;
  Glide glide = Glide::kLinear;
};
// The limits of frequencies.
constexpr CurveLimits kHertz{0.01, 20000, Glide::kExponential};

// Reads a setting, or the next positional value, as a curve of a voice that lasts `length_s`. An invalid text
// or a value outside the limits is recorded as a problem, and the result is constantly `fallback`.
Curve read_curve_setting(Arguments& io_arguments, std::string_view name, double fallback,
                         const CurveLimits& limits, double length_s);
Curve read_curve_value(Arguments& io_arguments, double fallback, const CurveLimits& limits, double length_s);

// One part of "a..b@0.2..c": the text before the @, and the time.
struct TimedText {
  std::string_view text;
  double time_s = 0;
};
// Splits a list with times. Returns nothing if a time is not a number or earlier than the one before it, or
// if a part is empty.
std::vector<TimedText> parse_timed_texts(std::string_view text, double length_s);

}  // namespace temblor::artgen
