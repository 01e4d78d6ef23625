#include "vm/disassembly.h"

#include <fmt/format.h>

#include <bit>

#include "base/text.h"
#include "vm/code/decode.h"
#include "vm/code/opcodes.h"

namespace temblor::vm {
namespace {

// The name that compilers give to all constants.
constexpr std::string_view kConstant = "IMMEDIATE";

std::string describe_vector(const formats::Progs& progs, std::size_t word) {
  const auto at = [&](std::size_t i) { return std::bit_cast<float>(progs.global_words[word + i]); };
  return fmt::format("'{:g} {:g} {:g}'", at(0), at(1), at(2));
}

// Describes a constant by its value at load, which no statement of an ordinary program changes.
std::string describe_constant(const formats::Progs& progs, std::size_t word, formats::ProgsType type) {
  const std::uint32_t value = progs.global_words[word];
  if (type == formats::ProgsType::kVector) return describe_vector(progs, word);
  if (type == formats::ProgsType::kString && value < progs.strings.size())
    return fmt::format("\"{}\"", base::quotable(progs.string_at(value)));
  if (type == formats::ProgsType::kFloat) return fmt::format("{:g}", std::bit_cast<float>(value));
  return fmt::format("{:#x}", value);
}

// Words 1 to 27 have fixed meanings, and no definitions.
std::string describe_global(const Program& program, std::size_t word) {
  if (word == 1) return "return";
  if (word >= 4 && word < formats::kReservedGlobalWords && (word - 4) % 3 == 0)
    return fmt::format("parm{}", (word - 4) / 3);
  const formats::ProgsDefinition* definition = program.global_at(word);
  if (definition == nullptr) return fmt::format("{}", word);
  const std::string_view name = program.progs().string_at(definition->name);
  return name == kConstant || name.empty() ? describe_constant(program.progs(), word, definition->type)
                                           : base::quotable(name);
}

}  // namespace

std::string describe_statement(const Program& program, std::size_t statement) {
  const formats::ProgsStatement& source = program.progs().statements[statement];
  const OpcodeInfo& info = opcode_info(source.op);
  if (info.name.empty()) return fmt::format("OP_{}", source.op);
  std::string line = fmt::format("{:<10}", info.name);
  const char* separator = " ";
  for (std::size_t i = 0; i < info.operands.size(); ++i) {
    if (info.operands[i] == OperandKind::kNone) continue;
    line += separator;
    separator = ", ";
    if (info.operands[i] == OperandKind::kJump)
      line += fmt::format("to {}", static_cast<std::ptrdiff_t>(statement) +
                                       jump_distance(program.progs(), source.operands[i]));
    else if (info.operands[i] == OperandKind::kNumber)
      line += fmt::format("{}", source.operands[i]);
    else
      line += describe_global(program, source.operands[i]);
  }
  return line;
}

std::string disassemble(const Program& program, FunctionIndex index) {
  const formats::ProgsFunction& function = program.function(index);
  if (function.first_statement <= 0)
    return fmt::format("built-in function {}\n", -std::int64_t{function.first_statement});
  std::string lines;
  for (auto i = static_cast<std::size_t>(function.first_statement); i < program.function_end(index); ++i)
    lines += fmt::format("{:>6}  {}\n", i, describe_statement(program, i));
  return lines;
}

}  // namespace temblor::vm
