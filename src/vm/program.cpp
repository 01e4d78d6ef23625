#include "vm/program.h"

#include <algorithm>

#include "base/text.h"
#include "vm/code/decode.h"

namespace temblor::vm {
namespace {

const formats::ProgsDefinition* find_in(const std::map<std::string_view, std::size_t, std::less<>>& names,
                                        const std::vector<formats::ProgsDefinition>& definitions,
                                        std::string_view name) {
  const auto found = names.find(name);
  return found == names.end() ? nullptr : &definitions[found->second];
}

}  // namespace

Program::Program(formats::Progs progs, std::vector<std::uint32_t> lines)
    : progs_(std::move(progs)), lines_(std::move(lines)) {
  CHECK(lines_.empty() || lines_.size() == progs_.statements.size(), "{}", lines_.size());
  index_names();
  find_ends();
}

base::Result<std::shared_ptr<const Program>> Program::load(formats::Progs progs,
                                                           std::vector<std::uint32_t> lines) {
  std::shared_ptr<Program> program(new Program(std::move(progs), std::move(lines)));
  TRY_STATUS(program->decode_all());
  return std::shared_ptr<const Program>(std::move(program));
}

// emplace() keeps the first of several definitions with the same name. Function 0 is the null function.
void Program::index_names() {
  for (std::size_t i = 0; i < progs_.globals.size(); ++i) {
    globals_.emplace(progs_.string_at(progs_.globals[i].name), i);
    globals_by_word_.emplace(progs_.globals[i].offset, i);
  }
  for (std::size_t i = 0; i < progs_.fields.size(); ++i)
    fields_.emplace(progs_.string_at(progs_.fields[i].name), i);
  for (std::size_t i = 1; i < progs_.functions.size(); ++i)
    functions_.emplace(progs_.string_at(progs_.functions[i].name), i);
}

// Walks the functions from the last start to the first. Functions that start at the same statement end at the
// same place.
void Program::find_ends() {
  for (std::size_t i = 1; i < progs_.functions.size(); ++i) {
    const std::int32_t first = progs_.functions[i].first_statement;
    if (first > 0) starts_.emplace_back(static_cast<std::size_t>(first), base::to_index<FunctionIndex>(i));
  }
  std::ranges::sort(starts_);
  ends_.resize(progs_.functions.size());
  std::size_t end = progs_.statements.size(), begin_of_next = end;
  for (auto start = starts_.rbegin(); start != starts_.rend(); ++start) {
    if (start->first < begin_of_next) end = begin_of_next;
    begin_of_next = start->first;
    ends_[base::to_size(start->second)] = end;
  }
}

base::Status Program::decode_all() {
  instructions_.reserve(progs_.statements.size() + 1);
  for (std::size_t i = 0; i < progs_.statements.size(); ++i) {
    base::Result<Instruction> instruction = decode(progs_, i);
    if (!instruction.ok())
      return base::error(instruction.error().code, "statement {} (function \"{}\"): {}", i,
                         base::quotable(function_name(function_at(i))), instruction.error().what);
    instructions_.push_back(*instruction);
  }
  instructions_.emplace_back();
  fuse_pairs(instructions_);
  return base::Ok{};
}

const formats::ProgsDefinition* Program::find_global(std::string_view name) const {
  return find_in(globals_, progs_.globals, name);
}

const formats::ProgsDefinition* Program::find_field(std::string_view name) const {
  return find_in(fields_, progs_.fields, name);
}

const formats::ProgsDefinition* Program::global_at(std::size_t word) const {
  const auto found = globals_by_word_.find(word);
  return found == globals_by_word_.end() ? nullptr : &progs_.globals[found->second];
}

FunctionIndex Program::find_function(std::string_view name) const {
  const auto found = functions_.find(name);
  return found == functions_.end() ? kNoFunction : base::to_index<FunctionIndex>(found->second);
}

std::string Program::describe_place(FunctionIndex index, std::size_t statement) const {
  const std::string line =
      statement < lines_.size() && lines_[statement] > 0 ? fmt::format(":{}", lines_[statement]) : "";
  return fmt::format("{} ({}{}), statement {}", base::quotable(function_name(index)),
                     base::quotable(function_file(index)), line, statement);
}

FunctionIndex Program::function_at(std::size_t statement) const {
  const auto after =
      std::ranges::upper_bound(starts_, statement, {}, &std::pair<std::size_t, FunctionIndex>::first);
  return after == starts_.begin() ? kNoFunction : std::prev(after)->second;
}

}  // namespace temblor::vm
