// Random programs run the same with single statements (as in a trace) and with fused pairs, and cannot leave
// the machine.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <string>
#include <vector>

#include "support/effort.h"
#include "support/programs/progs_builder.h"
#include "support/random.h"
#include "vm/machine.h"

namespace temblor::vm {
namespace {

using formats::ProgsType;
using test::ProgsBuilder;

constexpr std::size_t kPlaces = 24, kStatements = 40;

// Values that are valid for at least one type.
std::uint32_t some_word(test::Random& random) {
  switch (random.below(4)) {
    case 0:
      return static_cast<std::uint32_t>(random.below(6));
    case 1:
      return std::bit_cast<std::uint32_t>(static_cast<float>(random.below(4)) - 1);
    case 2:
      return std::bit_cast<std::uint32_t>(static_cast<float>(random.uniform(-100, 100)));
    default:
      return random.chance(0.9) ? 0 : static_cast<std::uint32_t>(random.bits());
  }
}

std::shared_ptr<const Program> random_program(std::uint64_t seed) {
  test::Random random(seed);
  ProgsBuilder builder;
  builder.field("number", ProgsType::kFloat);
  builder.field("place", ProgsType::kVector);
  builder.field("other", ProgsType::kEntity);
  const auto begin = static_cast<std::size_t>(builder.words({}));
  for (std::size_t i = 0; i < kPlaces; ++i) builder.words({some_word(random)});
  const auto place = [&] { return static_cast<int>(begin + random.below(kPlaces - 2)); };
  for (const char* name : {"first", "second"}) {
    builder.function(name, {1, 3}, 2);
    for (std::size_t i = 0; i < kStatements; ++i) {
      auto opcode = static_cast<Opcode>(random.below(random.chance(0.7) ? kStockOpcodes : kOpcodes));
      if (opcode == Opcode::kDone || opcode == Opcode::kReturn) opcode = Opcode::kLt;
      std::array<int, 3> operands = {place(), place(), place()};
      // Often the result of the statement before, so that there are pairs to fuse.
      const auto& before = builder.progs().statements.back();
      if (random.chance(0.5)) operands[0] = static_cast<int>(before.operands[2]);
      if (random.chance(0.5)) operands[1] = static_cast<int>(before.operands[2]);
      for (std::size_t j = 0; j < 3; ++j)
        if (opcode_info(opcode).operands[j] == OperandKind::kJump)
          operands[j] = static_cast<int>(random.below(kStatements)) - static_cast<int>(i);
        else if (operands[j] < static_cast<int>(begin) || operands[j] > static_cast<int>(begin + kPlaces - 3))
          operands[j] = place();
      builder.emit(opcode, operands[0], operands[1], operands[2]);
    }
    builder.emit(Opcode::kDone);
  }
  return builder.load();
}

struct Outcome {
  std::string error;
  std::vector<std::uint32_t> globals, entities;
  std::uint64_t instructions = 0;
  bool operator==(const Outcome&) const = default;
};

Outcome run(const std::shared_ptr<const Program>& program, bool is_traced, std::size_t& io_lines) {
  Machine machine(program, {.call_depth = 20, .instructions = 2000});
  EXPECT_TRUE(machine.set_entity_count(4).ok());
  machine.protect_world(true);
  machine.set_state_fields({GlobalIndex{40}, GlobalIndex{41}, FieldIndex{0}, FieldIndex{1}, FieldIndex{2}});
  if (is_traced) machine.set_tracer([&](std::string_view) { ++io_lines; });
  Outcome outcome;
  const base::Status status = machine.call(program->find_function("first"));
  if (!status.ok()) outcome.error = status.error().what;
  const auto globals = std::as_const(machine).global_words();
  outcome.globals.assign(globals.begin(), globals.end());
  for (std::uint32_t i = 0; i < 4; ++i)
    for (const std::uint32_t word : machine.entity(EntityIndex{i})) outcome.entities.push_back(word);
  outcome.instructions = machine.instructions_run();
  return outcome;
}

TEST(Tracing, TracedAndUntracedRunsAreTheSame) {
  std::size_t finished = 0, total = 0;
  for (std::uint64_t seed = 0; seed < static_cast<std::uint64_t>(test::effort(20'000, 2000)); ++seed) {
    const auto program = random_program(seed);
    std::size_t lines = 0;
    const Outcome traced = run(program, true, lines), untraced = run(program, false, lines);
    ASSERT_EQ(traced, untraced) << seed << ": " << traced.error << " / " << untraced.error;
    ASSERT_EQ(lines, traced.instructions) << seed;
    finished += traced.error.empty() ? 1 : 0;
    total += lines;
  }
  EXPECT_GT(finished, 0u);
  EXPECT_GT(total, 10 * finished);
}

TEST(Tracing, ProgramsMayRunPastTheirEnd) {
  ProgsBuilder builder;
  builder.field("place", ProgsType::kVector);
  const int number = builder.number(1);
  for (int i = 0; i < 20; ++i) builder.number();  // run() names globals up to 41
  builder.function("first");
  builder.emit(Opcode::kStoreF, number, number);
  std::size_t lines = 0;
  const Outcome traced = run(builder.load(), true, lines);
  EXPECT_THAT(traced.error, ::testing::HasSubstr("it runs past the last statement"));
  EXPECT_EQ(lines, 1u);
}

}  // namespace
}  // namespace temblor::vm
