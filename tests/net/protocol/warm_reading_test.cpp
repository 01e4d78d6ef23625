// A warm message reader allocates no memory.
#include <gtest/gtest.h>

#include "net/protocol/message_reader.h"
#include "net/protocol/message_writer.h"
#include "net/protocol/random_message.h"
#include "support/allocation_counter.h"

namespace temblor::net {
namespace {

TEST(WarmReading, AllocatesNothing) {
  const Dialect dialect{Protocol::kFitzQuake, 0};
  const std::vector<std::string_view> models(300, "progs/model.mdl");
  base::ByteWriter writer;
  test::Random random(1);
  ASSERT_TRUE(write_message(ServerInfo{.dialect = dialect, .models = models}, dialect, writer).ok());
  for (int i = 0; i < 2000; ++i)
    ASSERT_TRUE(write_message(test::random_message(random, dialect), dialect, writer).ok());

  MessageReader reader;
  std::size_t first_allocations = 0;
  for (const bool warm : {false, true}) {
    const std::size_t before = test::allocation_count();
    std::size_t messages = 0;
    reader.begin(writer.view());
    for (auto message = reader.next(); message.value().has_value(); message = reader.next()) ++messages;
    const std::size_t allocations = test::allocation_count() - before;
    EXPECT_EQ(messages, 2001u);
    if (warm) {
      EXPECT_EQ(allocations, 0u);
    } else
      first_allocations = allocations;
  }
  EXPECT_GT(first_allocations, 0u) << "allocations are not counted";
}

}  // namespace
}  // namespace temblor::net
