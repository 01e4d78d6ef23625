#include "server/game/field_text.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstdlib>

#include "server/game/entity_fields.h"

namespace temblor::server {
namespace {

using formats::ProgsType;

// Reads a number as far as possible, and removes it from the text. The C library's rules are part of the map
// format: hexadecimal numbers and exponents are allowed.
float take_number(std::string_view& io_text) {
  const std::string text(io_text);  // strtof() needs a final zero
  char* end = nullptr;
  const float value = std::strtof(text.c_str(), &end);
  io_text.remove_prefix(static_cast<std::size_t>(end - text.c_str()));
  return std::isfinite(value) ? value : 0.0f;
}

// "\n" is the only escape of the map format.
std::string unescaped(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool is_newline = text[i] == '\\' && i + 1 < text.size() && text[i + 1] == 'n';
    result += is_newline ? '\n' : text[i];
    if (is_newline) ++i;
  }
  return result;
}

// The reverse, without quotes: the formats have no way to escape them.
std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '\n')
      result += "\\n";
    else if (c != '"' && c != '\0')
      result += c;
  }
  return result;
}

// Everything except a vector fits into one word.
base::Result<std::uint32_t> single_word(vm::Machine& io_machine, ProgsType type, std::string_view text) {
  const vm::Program& program = io_machine.program();
  switch (type) {
    case ProgsType::kString: {
      TRY(const vm::StringIndex made, io_machine.make_string(unescaped(text)));
      return static_cast<std::uint32_t>(made);
    }
    case ProgsType::kFloat:
      return std::bit_cast<std::uint32_t>(take_number(text));
    case ProgsType::kEntity: {
      const float number = take_number(text);
      if (number < 0 || number >= static_cast<float>(io_machine.entity_count()))
        return base::error(base::ErrorCode::kUsage, "there is no entity {}", number);
      return static_cast<std::uint32_t>(number);
    }
    case ProgsType::kField: {
      const formats::ProgsDefinition* field = program.find_field(text);
      if (!field) return base::error(base::ErrorCode::kUsage, "the program has no field \"{}\"", text);
      return std::uint32_t{field->offset};
    }
    case ProgsType::kFunction: {
      const vm::FunctionIndex function = program.find_function(text);
      if (function == vm::kNoFunction)
        return base::error(base::ErrorCode::kUsage, "the program has no function \"{}\"", text);
      return static_cast<std::uint32_t>(function);
    }
    default:
      return base::error(base::ErrorCode::kUsage, "a value of this type cannot be given as text");
  }
}

std::string_view find_field_name(const vm::Program& program, std::uint32_t offset) {
  for (const formats::ProgsDefinition& field : program.progs().fields)
    if (field.offset == offset) return program.progs().string_at(field.name);
  return "";
}

}  // namespace

base::Status set_value(vm::Machine& io_machine, const formats::ProgsDefinition& definition,
                       std::string_view text, std::span<std::uint32_t> out_words) {
  if (definition.type == ProgsType::kVector) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      out_words[axis] = std::bit_cast<std::uint32_t>(take_number(text));
    return base::Ok{};
  }
  TRY(out_words[0], single_word(io_machine, definition.type, text));
  return base::Ok{};
}

// Nine significant digits are enough to restore any float exactly.
std::string value_text(const vm::Machine& machine, const formats::ProgsDefinition& definition,
                       std::span<const std::uint32_t> words) {
  const vm::Program& program = machine.program();
  const auto number = [&](std::size_t i) { return std::bit_cast<float>(words[i]); };
  switch (definition.type) {
    case ProgsType::kString:
      return escaped(machine.text(vm::StringIndex{words[0]}));
    case ProgsType::kFloat:
      return fmt::format("{:.9g}", number(0));
    case ProgsType::kVector:
      return fmt::format("{:.9g} {:.9g} {:.9g}", number(0), number(1), number(2));
    case ProgsType::kEntity:
      return fmt::format("{}", words[0]);
    case ProgsType::kField:
      return std::string(find_field_name(program, words[0]));
    case ProgsType::kFunction: {
      const bool is_known = words[0] > 0 && words[0] < program.progs().functions.size();
      return is_known ? std::string(program.function_name(vm::FunctionIndex{words[0]})) : "";
    }
    default:
      return "";
  }
}

}  // namespace temblor::server
