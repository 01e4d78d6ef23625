// Compiled QuakeC (progs.dat): counts, functions, and a disassembly.
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "app/inspect/inspection.h"
#include "base/text.h"
#include "formats/game/progs.h"
#include "vm/disassembly.h"
#include "vm/program.h"

namespace temblor::app {
namespace {

// Size of the original virtual machine's stack of locals.
constexpr std::uint32_t kStockLocals = 2048;

Inspection count_parts(const formats::Progs& progs) {
  return {{"statements", progs.statements.size()},     {"functions", progs.functions.size()},
          {"globals", progs.globals.size()},           {"fields", progs.fields.size()},
          {"global words", progs.global_words.size()}, {"entity words", progs.entity_words},
          {"string bytes", progs.strings.size()}};
}

// A function with a negative first statement is a built-in function of the engine. Function 0 is always
// empty.
Inspection list_functions(const vm::Program& program) {
  Inspection functions = Inspection::array();
  for (std::size_t i = 1; i < program.progs().functions.size(); ++i) {
    const auto index = base::to_index<vm::FunctionIndex>(i);
    const formats::ProgsFunction& function = program.function(index);
    Inspection entry = {{"name", program.function_name(index)}, {"file", program.function_file(index)}};
    if (function.first_statement <= 0) {
      entry["built in"] = -std::int64_t{function.first_statement};
    } else {
      entry["parameters"] = function.parameter_count;
      entry["locals"] = function.local_count;
      entry["first statement"] = function.first_statement;
    }
    functions.push_back(entry);
  }
  return functions;
}

// Disassembles every function: a line with its name and source file, then a line per statement.
Inspection list_statements(const vm::Program& program) {
  Inspection lines = Inspection::array();
  for (std::size_t i = 1; i < program.progs().functions.size(); ++i) {
    const auto index = base::to_index<vm::FunctionIndex>(i);
    if (program.function(index).first_statement <= 0) continue;
    lines.push_back(fmt::format("{} ({})", program.function_name(index), program.function_file(index)));
    const std::string text = vm::disassemble(program, index);
    for (std::size_t begin = 0; begin < text.size();) {
      const std::size_t end = text.find('\n', begin);
      lines.push_back(text.substr(begin, end - begin));
      begin = end + 1;
    }
  }
  return lines;
}

Inspection find_problems(const vm::Program& program) {
  Inspection problems = Inspection::array();
  const formats::Progs& progs = program.progs();
  if (progs.crc != formats::kQuakeProgsCrc)
    problems.push_back(fmt::format("compiled with other system definitions than Quake's (CRC {}, not {})",
                                   progs.crc, formats::kQuakeProgsCrc));
  for (std::size_t i = 1; i < progs.functions.size(); ++i) {
    const auto index = base::to_index<vm::FunctionIndex>(i);
    if (progs.functions[i].first_statement > 0 && progs.functions[i].local_count > kStockLocals)
      problems.push_back(fmt::format("{} has {} locals: the original engine allows {}",
                                     program.function_name(index), progs.functions[i].local_count,
                                     kStockLocals));
    if (const vm::FunctionIndex first = program.find_function(program.function_name(index)); first != index)
      problems.push_back(fmt::format("functions {} and {} are both called \"{}\"", base::to_size(first), i,
                                     base::quotable(program.function_name(index))));
  }
  return problems;
}

}  // namespace

base::Result<Inspection> inspect_progs(base::Bytes bytes) {
  TRY(formats::Progs progs, formats::read_progs(bytes));
  TRY(const auto program, vm::Program::load(std::move(progs)));
  return Inspection{{"version", formats::kProgsVersion},       {"crc", program->progs().crc},
                    {"counts", count_parts(program->progs())}, {"functions", list_functions(*program)},
                    {"code", list_statements(*program)},       {"problems", find_problems(*program)}};
}

}  // namespace temblor::app
