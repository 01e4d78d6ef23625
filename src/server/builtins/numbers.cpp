// Built-in functions for numbers and random numbers.
#include <cmath>

#include "server/builtins/families.h"

namespace temblor::server {
namespace {

base::Status returned(Call& io_call, double value) {
  io_call.machine.return_float(static_cast<float>(value));
  return base::Ok{};
}

// random(): 0 to 1, both included.
base::Status random(Call& io_call) {
  return returned(io_call, io_call.game.random.next_fraction());
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

}  // namespace

std::span<const BuiltinEntry> number_builtins() {
  static constexpr BuiltinEntry kEntries[] = {
      {7, "random", random}, {36, "rint", rint}, {37, "floor", floor}, {38, "ceil", ceil},
      {43, "fabs", fabs},    {60, "sin", sin},   {61, "cos", cos},     {62, "sqrt", sqrt},
      {94, "min", min},      {95, "max", max},   {96, "bound", bound}, {97, "pow", pow},
  };
  return kEntries;
}

}  // namespace temblor::server
