// Messages round-trip in every dialect.
#include <gtest/gtest.h>

#include <set>

#include "net/protocol/message_reader.h"
#include "net/protocol/message_text.h"
#include "net/protocol/message_writer.h"
#include "net/protocol/random_message.h"
#include "support/effort.h"

namespace temblor::net {
namespace {

class RoundTrip : public ::testing::TestWithParam<Dialect> {};

// Several games, each with one packet of messages.
TEST_P(RoundTrip, AllMessages) {
  const Dialect dialect = GetParam();
  std::set<std::string> kinds;
  for (std::uint64_t seed = 0; seed < test::effort(3000, 300); ++seed) {
    test::Random random(seed);
    std::vector<ServerMessage> messages = {ServerInfo{.dialect = dialect, .level_name = "a level"}};
    for (std::size_t count = random.below(40); count > 0; --count)
      messages.push_back(test::random_message(random, dialect));
    base::ByteWriter writer;
    for (const ServerMessage& message : messages) {
      const base::Status status = write_message(message, dialect, writer);
      ASSERT_TRUE(status.ok()) << "seed " << seed << ": " << status.error().message();
    }
    MessageReader reader;
    reader.begin(writer.view());
    for (const ServerMessage& message : messages) {
      const auto read = reader.next();
      ASSERT_TRUE(read.ok()) << "seed " << seed << ": " << read.error().message();
      ASSERT_TRUE(read->has_value()) << "seed " << seed;
      ASSERT_EQ(test::get_text(**read), test::get_text(message)) << "seed " << seed;
      kinds.insert(message_name(**read));
    }
    ASSERT_FALSE(reader.next().value().has_value()) << "seed " << seed;
  }
  EXPECT_EQ(kinds.size(),
            std::variant_size_v<ServerMessage> - (dialect.protocol == Protocol::kNetQuake ? 4 : 1))
      << "a type of message never occurred";
}

INSTANTIATE_TEST_SUITE_P(Dialects, RoundTrip,
                         ::testing::Values(Dialect{Protocol::kNetQuake, 0}, Dialect{Protocol::kFitzQuake, 0},
                                           Dialect{Protocol::kRmq, 0}, Dialect{Protocol::kRmq, kShortAngle},
                                           Dialect{Protocol::kRmq, kInt32Coord | kShortAngle},
                                           Dialect{Protocol::kRmq, k24BitCoord},
                                           Dialect{Protocol::kRmq, kFloatCoord | kFloatAngle},
                                           Dialect{Protocol::kRmq, kKnownProtocolFlags}),
                         [](const auto& dialect) {
                           return std::to_string(static_cast<int>(dialect.param.protocol)) + "_" +
                                  std::to_string(dialect.param.flags);
                         });

}  // namespace
}  // namespace temblor::net
