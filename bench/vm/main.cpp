// Measures the QuakeC interpreter: instructions per second and the cost of calls, with the statements that
// fteqcc emits.
#include <benchmark/benchmark.h>

#include "support/programs/progs_builder.h"
#include "vm/machine.h"

namespace temblor::bench {
namespace {

using formats::ProgsType;
using test::ProgsBuilder;
using vm::Opcode;

// Calls `main` repeatedly. Reports instructions per second, and nanoseconds for each of `calls` calls.
void run_main(benchmark::State& state, ProgsBuilder& builder, double calls) {
  vm::Machine machine(builder.load(), {.instructions = 1'000'000'000});
  machine.add_builtin(1, "nothing", [](vm::Machine&) -> base::Status { return base::Ok{}; });
  const vm::FunctionIndex main = machine.program().find_function("main");
  for (auto _ : state) {
    const base::Status status = machine.call(main);
    CHECK(status.ok(), "{}", status.error().message());
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(machine.instructions_run()));
  if (calls > 0)
    state.counters["call"] = benchmark::Counter(calls * static_cast<double>(state.iterations()),
                                                benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

constexpr float kTurns = 100'000;

// i = 0; while (i < kTurns) { BODY; i = i + 1; }
template <typename Body>
void emit_loop(ProgsBuilder& io_builder, Body body) {
  const int zero = io_builder.number(0), one = io_builder.number(1), turns = io_builder.number(kTurns),
            i = io_builder.number(), test = io_builder.number();
  io_builder.function("main");
  io_builder.emit(Opcode::kStoreF, zero, i);
  const int loop = io_builder.emit(Opcode::kLt, i, turns, test);
  const int out = io_builder.emit(Opcode::kIfNot, test);
  body();
  io_builder.emit(Opcode::kAddF, i, one, i);
  const int back = io_builder.emit(Opcode::kGoto);
  io_builder.progs().statements.back().operands[0] = static_cast<std::uint16_t>(loop - back);
  io_builder.land(out);
  io_builder.emit(Opcode::kDone);
}

// Loads, arithmetic, comparisons, and branches: a random number generator in an entity field, two tests of
// its results that a branch predictor cannot learn, and a sum.
void loop_of_everything(benchmark::State& state) {
  ProgsBuilder builder;
  const int seed_field = builder.field("seed", ProgsType::kFloat), self = builder.number(0);
  const int seed = builder.number(), factor = builder.number(69), limit = builder.number(4093),
            middle = builder.number(2000), sum = builder.number(), test = builder.number(),
            temporary = builder.number(), place = builder.number(), most = builder.number(1e6f),
            one = builder.number(1), high = builder.number(), mask = builder.number(4095);
  emit_loop(builder, [&] {
    builder.emit(Opcode::kLoadF, self, seed_field, seed);
    builder.emit(Opcode::kMulF, seed, factor, temporary);
    builder.emit(Opcode::kAddF, temporary, one, temporary);
    builder.emit(Opcode::kBitAnd, temporary, mask, seed);
    builder.emit(Opcode::kAddress, self, seed_field, place);
    builder.emit(Opcode::kStorePF, seed, place);
    builder.emit(Opcode::kGt, seed, middle, test);
    const int low = builder.emit(Opcode::kIfNot, test);
    builder.emit(Opcode::kAddF, high, one, high);
    builder.emit(Opcode::kSubF, seed, middle, seed);
    builder.land(low);
    builder.emit(Opcode::kMulF, seed, factor, temporary);
    builder.emit(Opcode::kAddF, sum, temporary, sum);
    builder.emit(Opcode::kGe, sum, most, test);
    const int small = builder.emit(Opcode::kIfNot, test);
    builder.emit(Opcode::kSubF, sum, most, sum);
    builder.land(small);
    builder.emit(Opcode::kLe, sum, limit, test);
  });
  run_main(state, builder, 0);
}
BENCHMARK(loop_of_everything)->Unit(benchmark::kMillisecond);

// Arithmetic with entities' vector fields.
void loop_of_vectors(benchmark::State& state) {
  ProgsBuilder builder;
  const int origin_field = builder.field("origin", ProgsType::kVector), self = builder.number(0);
  const int origin = builder.vector(), step = builder.vector(0.125f, -0.25f, 0.5f),
            half = builder.number(0.5f), place = builder.number(), length = builder.number();
  emit_loop(builder, [&] {
    builder.emit(Opcode::kLoadV, self, origin_field, origin);
    builder.emit(Opcode::kAddV, origin, step, origin);
    builder.emit(Opcode::kMulVF, origin, half, origin);
    builder.emit(Opcode::kMulV, origin, step, length);
    builder.emit(Opcode::kAddress, self, origin_field, place);
    builder.emit(Opcode::kStorePV, origin, place);
  });
  run_main(state, builder, 0);
}
BENCHMARK(loop_of_vectors)->Unit(benchmark::kMillisecond);

// A function of two parameters and four more locals that returns their sum.
void call_and_return(benchmark::State& state) {
  ProgsBuilder builder;
  const int sum = builder.number();
  const int add = builder.function("add", {1, 1}, 4), a = builder.locals();
  builder.emit(Opcode::kAddF, a, a + 1, sum);
  builder.emit(Opcode::kReturn, sum);
  emit_loop(builder, [&] {
    builder.emit(Opcode::kStoreF, sum, 4);
    builder.emit(Opcode::kStoreF, sum, 7);
    builder.emit(Opcode::kCall2, add);
    builder.emit(Opcode::kStoreF, 1, sum);
  });
  run_main(state, builder, kTurns);
}
BENCHMARK(call_and_return)->Unit(benchmark::kMillisecond);

void call_built_in_function(benchmark::State& state) {
  ProgsBuilder builder;
  const int nothing = builder.builtin("nothing", 1);
  emit_loop(builder, [&] { builder.emit(Opcode::kCall0, nothing); });
  run_main(state, builder, kTurns);
}
BENCHMARK(call_built_in_function)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace temblor::bench

BENCHMARK_MAIN();
