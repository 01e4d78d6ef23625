// Every built-in function with parameters that no good program passes: an error or a result, never a crash,
// an endless loop or unbounded memory.
#include <gtest/gtest.h>

#include <limits>

#include "server/builtins/builtin_numbers.h"
#include "server/builtins/builtin_stage.h"
#include "support/effort.h"
#include "support/random.h"

namespace temblor::test {
namespace {

constexpr std::uint32_t kBadWords[] = {
    0,          1,          2,          3,          5,          28,         104,        105,
    110,        111,        0xffffffff, 0x80000000, 0x80000001, 0x7fc00000, 0x7f800000, 0xff800000,
    0x7f7fffff, 0x3f800000, 0x40000000, 0xbf800000, 0x4f000000, 0xcf000001, 0x42c80000, 0x00800000};

std::uint32_t bad_word(Random& io_random) {
  if (io_random.chance(0.2)) return static_cast<std::uint32_t>(io_random.bits());
  return kBadWords[io_random.below(std::size(kBadWords))];
}

void set_bad_parameters(Stage& io_stage, Random& io_random) {
  for (int i = 0; i < vm::Machine::kMaxParameters; ++i) {
    if (io_random.chance(0.2)) {
      const std::string_view texts[] = {"",   "*1",  "maps/small.bsp", "../x", "%s%999d%v", "teamplay",
                                        "\"", "'1 2"};
      io_stage.set_parameter(i, texts[io_random.below(std::size(texts))]);
      continue;
    }
    const std::uint32_t x = bad_word(io_random), y = bad_word(io_random), z = bad_word(io_random);
    io_stage.set_parameter(
        i, math::Vec3(std::bit_cast<float>(x), std::bit_cast<float>(y), std::bit_cast<float>(z)));
  }
}

// Random entities with random fields.
void fill_world(Stage& io_stage, Random& io_random) {
  for (int i = 0; i < 6; ++i) {
    const vm::EntityIndex made = io_stage.spawn();
    for (std::uint32_t& word : io_stage.edict(made).words())
      if (io_random.chance(0.5)) word = bad_word(io_random);
  }
}

TEST(HostileBuiltins, NothingButErrors) {
  std::size_t errors = 0, results = 0;
  for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(effort(60, 8)); ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    Stage stage(random.chance(0.5) ? net::Dialect{} : net::Dialect{net::Protocol::kFitzQuake, 0});
    stage.precache.is_open = random.chance(0.5);
    fill_world(stage, random);
    for (int i = 0; i < 400; ++i) {
      const int number = 1 + static_cast<int>(random.below(120));
      const int rare[] = {400, 402, 403, 440, 441, 442, 448, 449, 627, 221, 223, 224, 225, 226, 228, 232, 233,
                          260, 245, 218, 460, 463, 464, 465, 467, 468, 469, 479, 484, 497, 511, 514, 605};
      set_bad_parameters(stage, random);
      stage.machine.set_global_entity(server::global::kMessageEntity, vm::EntityIndex{bad_word(random) % 4});
      stage.machine.set_global_entity(server::global::kSelf, vm::EntityIndex{bad_word(random) % 9});
      const base::Status status = stage.call_function(
          stage.function_of_number(random.chance(0.2) ? rare[random.below(std::size(rare))] : number),
          random.below(9));
      ++(status.ok() ? results : errors);
      if (stage.printed.size() > (1 << 20)) stage.printed.clear();
      ASSERT_LT(stage.requests.commands.size(), std::size_t{1} << 17);
      stage.world.time_s += 0.03;
    }
    // The machine still works, and so does the world.
    EXPECT_EQ(stage.number("floor", 1.5f), 1);
    EXPECT_FALSE(stage.world.edicts.is_free(vm::kWorld));
  }
  EXPECT_GT(errors, 1000u * 8 / 60);
  EXPECT_GT(results, 1000u * 8 / 60);
}

TEST(HostileBuiltins, SpawningHasAnEnd) {
  Stage stage;
  std::string error;
  int spawned = 0;
  for (; spawned < 100000 && error.empty(); ++spawned) error = stage.error("spawn");
  EXPECT_NE(error.find("builtin spawn: "), std::string::npos) << error;
  EXPECT_LE(stage.machine.entity_count(), 32000u);
}

TEST(HostileBuiltins, AChainThatBitesItsTailDoesNotMatter) {
  Stage stage;
  const vm::EntityIndex a = stage.spawn(), b = stage.spawn();
  for (const vm::EntityIndex entity : {a, b}) stage.set_text(entity, kTagField, "x");
  stage.edict(a).set(server::field::kChain, b);
  stage.edict(b).set(server::field::kChain, a);
  EXPECT_EQ(stage.entity("findchain", kTagField, "x"), b);
  EXPECT_EQ(stage.edict(b)[server::field::kChain], a);
  EXPECT_EQ(stage.edict(a)[server::field::kChain], vm::kWorld);
}

}  // namespace
}  // namespace temblor::test
