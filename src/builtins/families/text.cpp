// Built-in functions that convert numbers to text and back, and cut and join text. Each result is a
// new string. The original has one buffer, which the next call overwrites.
#include <algorithm>

#include "builtins/families/families.h"
#include "builtins/families/printf_format.h"
#include "builtins/families/text_to_number.h"
#include "builtins/number_text.h"

namespace temblor::builtins {
namespace {

// ftos(), vtos() and etos(): a number, a vector and an entity as text.
base::Status ftos(Call& io_call) {
  return io_call.return_text(number_text(io_call.number(0)));
}
base::Status vtos(Call& io_call) {
  return io_call.return_text(vector_text(io_call.vector(0)));
}
base::Status etos(Call& io_call) {
  TRY(const vm::EntityIndex entity, io_call.entity(0));
  return io_call.return_text(fmt::format("entity {}", base::to_size(entity)));
}
// stof() and stov(): the reverse. Text without a number is 0.
base::Status stof(Call& io_call) {
  io_call.machine.return_float(number_from(io_call.text(0)));
  return base::Ok{};
}
base::Status stov(Call& io_call) {
  io_call.machine.return_vector(vector_from(io_call.text(0)));
  return base::Ok{};
}

// Counts bytes: the game's characters have one byte each.
base::Status strlen(Call& io_call) {
  io_call.machine.return_float(static_cast<float>(io_call.text(0).size()));
  return base::Ok{};
}

base::Status strcat(Call& io_call) {
  return io_call.return_text(io_call.joined_text(0));
}

// substring(text, first, count): the part of the range that exists. A negative `first` counts from the end,
// and a negative `count` leaves out that many characters at the end, minus one (FTE_STRINGS).
base::Status substring(Call& io_call) {
  const std::string text(io_call.text(0));
  const auto size = static_cast<std::int64_t>(text.size());
  std::int64_t first = io_call.whole(1), count = io_call.whole(2);
  if (first < 0) first = std::max<std::int64_t>(first + size, 0);
  if (count < 0) count = std::max<std::int64_t>(size - first + count + 1, 0);
  const auto begin = static_cast<std::size_t>(std::min(first, size));
  return io_call.return_text(std::string_view(text).substr(begin, static_cast<std::size_t>(count)));
}

// strzone(): a copy that lives until strunzone().
base::Status strzone(Call& io_call) {
  TRY(const vm::StringIndex zoned, io_call.machine.strings().zone(std::string(io_call.text(0))));
  io_call.machine.return_string(zoned);
  return base::Ok{};
}
base::Status strunzone(Call& io_call) {
  if (!io_call.machine.strings().unzone(io_call.machine.parameter_string(0)))
    io_call.warn_once("a string that strzone() did not make");
  return base::Ok{};
}

base::Status sprintf(Call& io_call) {
  return io_call.return_text(format_parameters(io_call.text(0), io_call.machine, 1));
}

}  // namespace

std::span<const Entry> text_builtins() {
  static constexpr Entry kEntries[] = {
      {26, "ftos", ftos},
      {27, "vtos", vtos},
      {65, "etos", etos},
      {81, "stof", stof},
      {114, "strlen", strlen},
      {115, "strcat", strcat},
      {116, "substring", substring},
      {117, "stov", stov},
      {118, "strzone", strzone},
      {119, "strunzone", strunzone},
      {627, "sprintf", sprintf},
  };
  return kEntries;
}

}  // namespace temblor::builtins
