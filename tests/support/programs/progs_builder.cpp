#include "support/programs/progs_builder.h"

#include <bit>

namespace temblor::test {
namespace {

// Function 0 and statement 0 of every program are empty: "DONE".
constexpr formats::ProgsStatement kNothing{};

}  // namespace

ProgsBuilder::ProgsBuilder() {
  progs_.crc = formats::kQuakeProgsCrc;
  progs_.strings.push_back('\0');
  progs_.global_words.resize(formats::kReservedGlobalWords);
  progs_.statements.push_back(kNothing);
  progs_.functions.emplace_back();
}

std::uint32_t ProgsBuilder::add_string(std::string_view text) {
  const auto at = static_cast<std::uint32_t>(progs_.strings.size());
  progs_.strings.append(text).push_back('\0');
  return at;
}

int ProgsBuilder::words(std::initializer_list<std::uint32_t> values) {
  const auto at = static_cast<int>(progs_.global_words.size());
  progs_.global_words.insert(progs_.global_words.end(), values);
  return at;
}

int ProgsBuilder::number(float value) {
  return words({std::bit_cast<std::uint32_t>(value)});
}

int ProgsBuilder::vector(float x, float y, float z) {
  return words(
      {std::bit_cast<std::uint32_t>(x), std::bit_cast<std::uint32_t>(y), std::bit_cast<std::uint32_t>(z)});
}

int ProgsBuilder::text(std::string_view text) {
  return words({add_string(text)});
}

int ProgsBuilder::named(std::string_view name, formats::ProgsType type) {
  const int at = type == formats::ProgsType::kVector ? words({0, 0, 0}) : words({0});
  progs_.globals.push_back({type, true, static_cast<std::uint32_t>(at), add_string(name)});
  return at;
}

int ProgsBuilder::field(std::string_view name, formats::ProgsType type) {
  const std::uint32_t offset = progs_.entity_words;
  progs_.entity_words += formats::value_words(type);
  const std::uint32_t name_at = add_string(name);
  progs_.fields.push_back({type, false, offset, name_at});
  const int at = words({offset});
  progs_.globals.push_back({formats::ProgsType::kField, false, static_cast<std::uint32_t>(at), name_at});
  return at;
}

int ProgsBuilder::add_function(formats::ProgsFunction function, std::string_view name) {
  function.name = add_string(name);
  function.file = add_string("test.qc");
  const int at = words({static_cast<std::uint32_t>(progs_.functions.size())});
  progs_.functions.push_back(function);
  progs_.globals.push_back(
      {formats::ProgsType::kFunction, false, static_cast<std::uint32_t>(at), function.name});
  return at;
}

int ProgsBuilder::function(std::string_view name, std::initializer_list<int> parameter_words,
                           std::uint32_t further_locals) {
  formats::ProgsFunction function;
  function.first_statement = static_cast<std::int32_t>(progs_.statements.size());
  function.first_local = static_cast<std::uint32_t>(progs_.global_words.size());
  for (const int count : parameter_words) {
    function.parameter_words[static_cast<std::size_t>(function.parameter_count++)] =
        static_cast<std::uint8_t>(count);
    function.local_count += static_cast<std::uint32_t>(count);
  }
  function.local_count += further_locals;
  locals_ = static_cast<int>(function.first_local);
  progs_.global_words.resize(progs_.global_words.size() + function.local_count);
  return add_function(function, name);
}

int ProgsBuilder::builtin(std::string_view name, int number) {
  formats::ProgsFunction function;
  function.first_statement = -number;
  return add_function(function, name);
}

int ProgsBuilder::emit(vm::Opcode opcode, int a, int b, int c) {
  progs_.statements.push_back(
      {static_cast<std::uint16_t>(opcode),
       {static_cast<std::uint16_t>(a), static_cast<std::uint16_t>(b), static_cast<std::uint16_t>(c)}});
  return static_cast<int>(progs_.statements.size()) - 1;
}

void ProgsBuilder::land(int from) {
  formats::ProgsStatement& jump = progs_.statements[static_cast<std::size_t>(from)];
  const std::size_t operand = static_cast<vm::Opcode>(jump.op) == vm::Opcode::kGoto ? 0 : 1;
  jump.operands[operand] = static_cast<std::uint16_t>(static_cast<int>(progs_.statements.size()) - from);
}

std::shared_ptr<const vm::Program> ProgsBuilder::load() const {
  // Write and read it like a file, so that it passes the checks for files too.
  auto read = formats::read_progs(formats::write_progs(progs_));
  CHECK(read.ok(), "{}", read.error().message());
  auto program = vm::Program::load(std::move(*read));
  CHECK(program.ok(), "{}", program.error().message());
  return *program;
}

}  // namespace temblor::test
