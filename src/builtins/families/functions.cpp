// Built-in functions that look at the program itself: its functions and fields, by name and number.
#include "builtins/families/families.h"

namespace temblor::builtins {
namespace {

// isfunction(name)
base::Status isfunction(Call& io_call) {
  const bool is_there = io_call.machine.program().find_function(io_call.text(0)) != vm::kNoFunction;
  return io_call.return_number(is_there ? 1 : 0);
}

// callfunction(..., name): passes all parameters before the name.
base::Status callfunction(Call& io_call) {
  if (io_call.count() < 1) return io_call.error("needs the name of a function");
  const std::string name(io_call.text(io_call.count() - 1));
  const vm::FunctionIndex function = io_call.machine.program().find_function(name);
  if (function == vm::kNoFunction) {
    io_call.warn_once(fmt::format("there is no function \"{}\"", name.substr(0, 64)));
    return base::Ok{};
  }
  return io_call.machine.call(function);
}

const formats::ProgsDefinition* field_of_number(const Call& call) {
  const auto& fields = call.machine.program().progs().fields;
  const int i = call.whole(0);
  return i >= 0 && static_cast<std::size_t>(i) < fields.size() ? &fields[static_cast<std::size_t>(i)]
                                                               : nullptr;
}
base::Status numentityfields(Call& io_call) {
  return io_call.return_number(static_cast<double>(io_call.machine.program().progs().fields.size()));
}
// entityfieldname() and entityfieldtype(): empty and 0 if there is no field of that number.
base::Status entityfieldname(Call& io_call) {
  const formats::ProgsDefinition* const field = field_of_number(io_call);
  return io_call.return_text(field == nullptr ? ""
                                              : io_call.machine.program().progs().string_at(field->name));
}
base::Status entityfieldtype(Call& io_call) {
  const formats::ProgsDefinition* const field = field_of_number(io_call);
  return io_call.return_number(field == nullptr ? 0 : static_cast<double>(field->type));
}

}  // namespace

std::span<const Entry> function_builtins() {
  static constexpr Entry kEntries[] = {
      {605, "callfunction", callfunction},       {607, "isfunction", isfunction},
      {496, "numentityfields", numentityfields}, {497, "entityfieldname", entityfieldname},
      {498, "entityfieldtype", entityfieldtype},
  };
  return kEntries;
}

}  // namespace temblor::builtins
