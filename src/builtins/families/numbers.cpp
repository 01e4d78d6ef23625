// Built-in functions for numbers, random numbers, and time.
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "builtins/families/families.h"

namespace temblor::builtins {
namespace {

base::Status returned(Call& io_call, double value) {
  io_call.machine.return_float(static_cast<float>(value));
  return base::Ok{};
}

// random(): 0 to 1, both included.
base::Status random(Call& io_call) {
  return returned(io_call, io_call.context.random());
}

// rint(): rounds halves away from 0.
base::Status rint(Call& io_call) {
  return returned(io_call, std::round(io_call.number(0)));
}
base::Status floor(Call& io_call) {
  return returned(io_call, std::floor(io_call.number(0)));
}
base::Status ceil(Call& io_call) {
  return returned(io_call, std::ceil(io_call.number(0)));
}
base::Status fabs(Call& io_call) {
  return returned(io_call, std::fabs(io_call.number(0)));
}

// sin() and cos() take radians.
base::Status sin(Call& io_call) {
  return returned(io_call, std::sin(double{io_call.number(0)}));
}
base::Status cos(Call& io_call) {
  return returned(io_call, std::cos(double{io_call.number(0)}));
}
base::Status sqrt(Call& io_call) {
  return returned(io_call, std::sqrt(double{io_call.number(0)}));
}
base::Status pow(Call& io_call) {
  return returned(io_call, std::pow(io_call.number(0), io_call.number(1)));
}

// Returns the parameter that wins against all others; the first of equal ones.
template <typename Wins>
base::Status return_winner(Call& io_call, Wins wins) {
  const int count = io_call.machine.parameter_count();
  if (count < 2) return io_call.error("takes 2 to 8 numbers, not {}", count);
  float value = io_call.number(0);
  for (int i = 1; i < count; ++i)
    if (wins(io_call.number(i), value)) value = io_call.number(i);
  return returned(io_call, value);
}
base::Status min(Call& io_call) {
  return return_winner(io_call, [](float a, float b) { return a < b; });
}
base::Status max(Call& io_call) {
  return return_winner(io_call, [](float a, float b) { return a > b; });
}

// bound(low, value, high): if low is greater than high, the result is low.
base::Status bound(Call& io_call) {
  const float low = io_call.number(0), value = io_call.number(1), high = io_call.number(2);
  return returned(io_call, std::fmax(low, std::fmin(value, high)));
}

// tan(), asin(), acos(), and atan() use radians, as sin() does.
base::Status tan(Call& io_call) {
  return returned(io_call, std::tan(double{io_call.number(0)}));
}
base::Status asin(Call& io_call) {
  return returned(io_call, std::asin(double{io_call.number(0)}));
}
base::Status acos(Call& io_call) {
  return returned(io_call, std::acos(double{io_call.number(0)}));
}
base::Status atan(Call& io_call) {
  return returned(io_call, std::atan(double{io_call.number(0)}));
}
base::Status atan2(Call& io_call) {
  return returned(io_call, std::atan2(double{io_call.number(0)}, double{io_call.number(1)}));
}

// anglemod(): the same angle from 0 to 360.
base::Status anglemod(Call& io_call) {
  const double angle = std::fmod(double{io_call.number(0)}, 360);
  return returned(io_call, angle < 0 ? angle + 360 : angle);
}

// mod(a, n): the rest of the division, with the sign of a. A division by 0 gives 0.
base::Status mod(Call& io_call) {
  const float divisor = io_call.number(1);
  return returned(io_call, divisor == 0 ? 0 : std::fmod(double{io_call.number(0)}, double{divisor}));
}

// bitshift(value, count): to the left, or to the right if the count is negative.
base::Status bitshift(Call& io_call) {
  const int value = io_call.whole(0), count = std::clamp(io_call.whole(1), -31, 31);
  if (count < 0) return returned(io_call, value >> -count);
  return returned(io_call, static_cast<std::int32_t>(static_cast<std::uint32_t>(value) << count));
}

// gettime(): seconds since an arbitrary moment; all clocks are the same here.
base::Status gettime(Call& io_call) {
  return returned(io_call, io_call.context.time_s());
}

}  // namespace

std::span<const Entry> number_builtins() {
  static constexpr Entry kEntries[] = {
      {7, "random", random},
      {36, "rint", rint},
      {37, "floor", floor},
      {38, "ceil", ceil},
      {43, "fabs", fabs},
      {60, "sin", sin},
      {61, "cos", cos},
      {62, "sqrt", sqrt},
      {94, "min", min},
      {95, "max", max},
      {96, "bound", bound},
      {97, "pow", pow},
      {245, "mod", mod},
      {471, "asin", asin},
      {472, "acos", acos},
      {473, "atan", atan},
      {474, "atan2", atan2},
      {475, "tan", tan},
      {102, "anglemod", anglemod},
      {218, "bitshift", bitshift},
      {519, "gettime", gettime},
  };
  return kEntries;
}

}  // namespace temblor::builtins
