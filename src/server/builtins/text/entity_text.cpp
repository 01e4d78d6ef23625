#include "server/builtins/text/entity_text.h"

#include <algorithm>
#include <bit>
#include <span>

#include "builtins/number_text.h"

namespace temblor::server {
namespace {

using formats::ProgsType;

// A vector field has three more definitions, for its components ("origin_x").
bool is_component(std::string_view name) {
  return name.size() > 2 && name[name.size() - 2] == '_';
}

// Unlike field_text.h, this is for people: the text shows the type of each value.
std::string value_text(const vm::Machine& machine, ProgsType type, std::span<const std::uint32_t> words) {
  const std::uint32_t word = words[0];
  switch (type) {
    case ProgsType::kString:
      return fmt::format("\"{}\"", machine.text(vm::StringIndex{word}));
    case ProgsType::kFloat:
      return builtins::number_text(std::bit_cast<float>(word));
    case ProgsType::kVector:
      return builtins::vector_text(
          {std::bit_cast<float>(words[0]), std::bit_cast<float>(words[1]), std::bit_cast<float>(words[2])});
    case ProgsType::kEntity:
      return fmt::format("entity {}", word);
    case ProgsType::kField:
      return fmt::format("field {}", word);
    case ProgsType::kFunction:
      if (word >= machine.program().progs().functions.size()) break;
      return fmt::format("{}()", machine.program().function_name(vm::FunctionIndex{word}));
    default:
      break;
  }
  return fmt::format("{:#x}", word);
}

}  // namespace

std::string describe_entity(const Edicts& edicts, const vm::Machine& machine, vm::EntityIndex entity) {
  if (edicts.is_free(entity)) return fmt::format("entity {}: removed\n", base::to_size(entity));
  std::string text = fmt::format("entity {}:\n", base::to_size(entity));
  const std::span<const std::uint32_t> words = machine.entity(entity);
  for (const formats::ProgsDefinition& field : machine.program().progs().fields) {
    const std::string_view name = machine.program().progs().string_at(field.name);
    const auto value = words.subspan(field.offset, formats::value_words(field.type));
    const bool is_zero =
        std::all_of(value.begin(), value.end(), [](std::uint32_t word) { return word == 0; });
    if (is_zero || is_component(name)) continue;
    text += fmt::format("  {:<15} {}\n", name, value_text(machine, field.type, value));
  }
  return text;
}

}  // namespace temblor::server
