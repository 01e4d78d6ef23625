#include "compiler/light/shadows/shadow_record.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/effort.h"
#include "support/mutations.h"
#include "support/random.h"

namespace temblor::compiler {
namespace {

using test::effort;
using test::Random;

struct Asked {
  std::uint32_t light = 0;
  std::vector<std::uint32_t> luxels;
  bool rough = false;
  std::vector<Share> shares;
};

// Shares of each kind that is written in its own way: none, all, both, grays, colors.
Share random_share(Random& random, std::size_t kind) {
  const auto step = [&] { return static_cast<std::uint8_t>(random.below(kWholeShare + 1)); };
  if (kind == 0) return {};
  if (kind == 1 || (kind == 2 && random.chance(0.5))) return {kWholeShare, kWholeShare, kWholeShare};
  if (kind == 2) return {};
  const std::uint8_t gray = step();
  return kind == 3 ? Share{gray, gray, gray} : Share{step(), step(), step()};
}

std::vector<Asked> random_questions(Random& random, std::size_t luxels_of_face) {
  std::vector<Asked> asked;
  std::uint32_t light = 0;
  for (std::size_t i = random.below(40); i > 0; --i) {
    light += static_cast<std::uint32_t>(random.log_uniform(1, random.chance(0.1) ? 1e6 : 12));
    Asked question{light++, {}, random.chance(0.5), {}};
    const double density = random.chance(0.5) ? 1 : random.uniform(0, 1);
    const std::size_t kind = random.below(5);
    for (std::uint32_t luxel = 0; luxel < luxels_of_face; ++luxel)
      if (random.chance(density)) question.luxels.push_back(luxel);
    if (question.luxels.empty()) question.luxels.push_back(0);
    for (std::size_t k = 0; k < question.luxels.size(); ++k)
      question.shares.push_back(random_share(random, kind));
    asked.push_back(std::move(question));
  }
  return asked;
}

base::ByteVector written(const std::vector<Asked>& asked, std::size_t luxels_of_face) {
  ShadowWriter writer(luxels_of_face);
  for (const Asked& question : asked)
    writer.add({question.light, question.luxels, question.rough}, question.shares);
  return std::move(writer).take();
}

TEST(ShadowRecord, AnswersOnlyTheSameQuestion) {
  for (std::uint64_t seed = 0; seed < effort(400, 60); ++seed) {
    Random random(seed);
    const std::size_t luxels = 1 + random.below(70);
    const std::vector<Asked> asked = random_questions(random, luxels);
    const base::ByteVector record = written(asked, luxels);
    ShadowReader reader(record, luxels);
    for (const Asked& question : asked) {
      const auto answer = reader.find({question.light, question.luxels, question.rough});
      ASSERT_TRUE(answer && std::ranges::equal(*answer, question.shares)) << "seed " << seed;
      EXPECT_FALSE(reader.find({question.light, question.luxels, !question.rough}));
      std::vector<std::uint32_t> fewer = question.luxels;
      fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(random.below(fewer.size())));
      EXPECT_FALSE(reader.find({question.light, fewer, question.rough}));
      const bool next_is_known = std::any_of(
          asked.begin(), asked.end(), [&](const Asked& other) { return other.light == question.light + 1; });
      if (next_is_known) continue;
      EXPECT_FALSE(reader.find({question.light + 1, question.luxels, question.rough}));
    }
  }
}

TEST(ShadowRecord, DistinguishesEqualNumbersOfLuxels) {
  const std::vector<Asked> asked{{3, {0, 1, 5}, false, std::vector<Share>(3)}};
  const base::ByteVector record = written(asked, 9);
  ShadowReader reader(record, 9);
  const std::vector<std::uint32_t> others{0, 2, 5};
  EXPECT_FALSE(reader.find({3, others, false}));
  EXPECT_TRUE(reader.find({3, asked[0].luxels, false}));
}

TEST(ShadowRecord, AllLightOrNoneTakesOneByte) {
  const std::vector<std::uint32_t> luxels{0, 1, 2, 3};
  for (const std::uint8_t share : {std::uint8_t{0}, kWholeShare})
    EXPECT_EQ(written({{2, luxels, false, std::vector<Share>(4, Share{share, share, share})}}, 4).size(), 1u);
}

TEST(ShadowRecord, ReadsTheStartOfDamagedBytes) {
  for (std::uint64_t seed = 0; seed < effort(60, 10); ++seed) {
    Random random(seed);
    const std::size_t luxels = 1 + random.below(30);
    const std::vector<Asked> asked = random_questions(random, luxels);
    const base::ByteVector record = written(asked, luxels);
    const auto ask_all = [&](const base::ByteVector& bytes) {
      ShadowReader reader(bytes, luxels);
      std::size_t answers = 0;
      for (const Asked& question : asked)
        answers += reader.find({question.light, question.luxels, question.rough}) ? 1 : 0;
      return answers;
    };
    std::size_t before = 0;
    test::for_each_truncation(record, [&](const base::ByteVector& bytes) {
      const std::size_t answers = ask_all(bytes);
      EXPECT_GE(answers, before);
      before = answers;
    });
    if (record.empty()) continue;
    // Any answer will do, as long as nothing beyond the bytes is read: the address sanitizer checks that.
    for (int i = 0; i < 20; ++i) EXPECT_LE(ask_all(test::with_flipped_bits(record, random)), asked.size());
  }
}

}  // namespace
}  // namespace temblor::compiler
