#include "net/delta/bit_coder.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/random.h"

namespace temblor::net {
namespace {

struct Bit {
  std::size_t model;
  bool value;
};

std::vector<Bit> random_bits(test::Random& random, std::size_t count, double probability) {
  std::vector<Bit> bits(count);
  for (Bit& bit : bits) bit = {random.below(3), random.chance(probability)};
  return bits;
}

TEST(BitCoder, RoundTrips) {
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    test::Random random(seed);
    const std::vector<Bit> bits = random_bits(random, random.below(3000), random.uniform(0, 1));
    base::ByteWriter writer;
    std::vector<BitModel> models(3);
    BitEncoder encoder(writer);
    for (const Bit& bit : bits) {
      encoder.bit(models[bit.model], bit.value);
      encoder.raw_bits(static_cast<std::uint32_t>(bit.model) + 0xfffffff0u, 32);
    }
    encoder.finish();
    models.assign(3, {});
    BitDecoder decoder(writer.view());
    for (const Bit& bit : bits) {
      ASSERT_EQ(decoder.bit(models[bit.model], false), bit.value) << "seed " << seed;
      ASSERT_EQ(decoder.raw_bits(0, 32), bit.model + 0xfffffff0u) << "seed " << seed;
    }
  }
}

// Compares the size with the entropy of independent bits (Shannon, 1948).
TEST(BitCoder, SizeIsCloseToEntropy) {
  for (const double p : {0.5, 0.2, 0.05, 0.01}) {
    test::Random random(9);
    constexpr std::size_t kCount = 100'000;
    base::ByteWriter writer;
    BitModel model;
    BitEncoder encoder(writer);
    for (std::size_t i = 0; i < kCount; ++i) encoder.bit(model, random.chance(p));
    encoder.finish();
    const double entropy = -p * std::log2(p) - (1 - p) * std::log2(1 - p);
    const double bits = 8 * static_cast<double>(writer.size()) / kCount;
    EXPECT_GT(bits, entropy * 0.97) << p;
    EXPECT_LT(bits, entropy + 0.03) << p << ": allowance for the adaptation";
  }
}

TEST(BitCoder, NoBitsTakeNoBytes) {
  base::ByteWriter writer;
  BitEncoder(writer).finish();
  EXPECT_EQ(writer.size(), 0u);
}

TEST(BitCoder, DecodesEndlesslyPastEnd) {
  BitDecoder decoder(base::Bytes{});
  BitModel model;
  for (int i = 0; i < 100'000; ++i) decoder.bit(model, false);
  EXPECT_GT(model.probability_of_one(), 0u);
  EXPECT_LT(model.probability_of_one(), 65536u);
}

}  // namespace
}  // namespace temblor::net
