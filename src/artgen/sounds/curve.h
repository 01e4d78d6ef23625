// Values that move while a sound lasts, as scripts write them:
//
//   440             all the time
//   440..110        from the voice's beginning to its end
//   0..1@0.05..0    by way of 1, which is reached after 0.05 s
//
// Points without a time lie evenly between those that have one.
#pragma once

#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

#include "artgen/scripts/script.h"
#include "artgen/sounds/signal.h"

namespace temblor::artgen {

// kSteady: the same distance each second; kByRatio: the same ratio, as pitch is heard. By ratio all values
// must be above 0.
enum class Glide { kSteady, kByRatio };

class Curve {
 public:
  struct Point {
    double time_s = 0, value = 0;
  };

  Curve(std::vector<Point> points, Glide glide) : points_(std::move(points)), glide_(glide) {}

  void scale(double factor) {
    for (Point& point : points_) point.value *= factor;
  }
  // Before the first point and after the last one it stays as there.
  double at(double time_s) const;
  // Its values at `count` times, 1 / rate apart; between every sixteenth in a straight line.
  Signal values(std::size_t count, double rate) const;

 private:
  std::vector<Point> points_;  // at least one, times never falling
  Glide glide_;
};

struct CurveLimits {
  double lowest = 0, highest = 1;
  Glide glide = Glide::kSteady;
};
constexpr CurveLimits kHertz{0.01, 20000, Glide::kByRatio};

// A setting, and the next value by place, of a voice that lasts for `length_s`. What is no curve or outside
// the limits is a complaint, and `otherwise` is what comes back.
Curve curve_setting(Arguments& io_arguments, std::string_view name, double otherwise,
                    const CurveLimits& limits, double length_s);
Curve curve_value(Arguments& io_arguments, double otherwise, const CurveLimits& limits, double length_s);

// The parts of "a..b@0.2..c": what stands before the @, and when. Nothing where a time is no number, lies
// before the one in front of it, or where a part is empty.
struct TimedWord {
  std::string_view word;
  double time_s = 0;
};
std::vector<TimedWord> timed_words(std::string_view text, double length_s);

}  // namespace temblor::artgen
