// HalfOpenTable: admission, and replacement of old entries.
#include "net/transport/admission/half_open.h"

#include <gtest/gtest.h>

#include "support/random.h"

namespace temblor::net {
namespace {

platform::Address at(std::size_t host, std::size_t port) {
  return platform::ip4_address({10, 1, static_cast<std::uint8_t>(host >> 8), static_cast<std::uint8_t>(host)},
                               static_cast<std::uint16_t>(port));
}

TEST(HalfOpenTable, FindsEntries) {
  HalfOpenTable table;
  ASSERT_NE(table.add(at(1, 1), 0, {}, 10), nullptr);
  ASSERT_NE(table.add(at(1, 2), 3, {}, 11), nullptr);
  EXPECT_EQ(table.find(at(1, 2))->socket, 3u);
  EXPECT_EQ(table.find(at(2, 1)), nullptr);
  table.remove(at(1, 1));
  EXPECT_EQ(table.find(at(1, 1)), nullptr);
  table.remove_older_than(10, 21);
  EXPECT_NE(table.find(at(1, 2)), nullptr);
  table.remove_older_than(10, 21.5);
  EXPECT_EQ(table.find(at(1, 2)), nullptr);
}

TEST(HalfOpenTable, OneHostCannotFillTable) {
  HalfOpenTable table;
  std::size_t held = 0;
  for (std::size_t port = 1; port <= 1000; ++port) held += table.add(at(1, port), 0, {}, 1) != nullptr;
  EXPECT_EQ(held, HalfOpenTable::kMaxEntriesPerHost);
  EXPECT_NE(table.add(at(2, 1), 0, {}, 1), nullptr);
  // A new entry replaces the oldest of the host, once that is old enough.
  EXPECT_EQ(table.add(at(1, 2000), 0, {}, 2.9), nullptr);
  EXPECT_NE(table.add(at(1, 2000), 0, {}, 3.1), nullptr);
  EXPECT_EQ(table.find(at(1, 1)), nullptr);
  EXPECT_NE(table.find(at(2, 1)), nullptr);
}

TEST(HalfOpenTable, ReplacesOldestWhenFull) {
  HalfOpenTable table;
  for (std::size_t host = 0; host < HalfOpenTable::kMaxEntries; ++host)
    EXPECT_NE(table.add(at(host, 1), 0, {}, static_cast<double>(host) / 100), nullptr);
  EXPECT_EQ(table.add(at(500, 1), 0, {}, 1.9), nullptr);
  EXPECT_NE(table.add(at(500, 1), 0, {}, 2.0), nullptr);
  EXPECT_EQ(table.find(at(0, 1)), nullptr);
}

// Random requests against a simple model of the rules.
TEST(HalfOpenTable, StaysBoundedAndKeepsYoungEntries) {
  test::Random random(1);
  HalfOpenTable table;
  double now_s = 0;
  for (int i = 0; i < 20000; ++i, now_s += random.uniform(0, 0.05)) {
    const platform::Address peer = at(random.below(6), 1 + random.below(200));
    std::vector<platform::Address> young;
    for (const HalfOpen& entry : table.entries())
      if (now_s - entry.began_s < HalfOpenTable::kMinAge_s) young.push_back(entry.address);
    if (table.find(peer) == nullptr) table.add(peer, 0, {}, now_s);
    ASSERT_LE(table.entries().size(), HalfOpenTable::kMaxEntries);
    for (const platform::Address& kept : young) ASSERT_NE(table.find(kept), nullptr);
    if (random.chance(0.1)) table.remove(peer);
    if (random.chance(0.1)) table.remove_older_than(10, now_s);
  }
}

}  // namespace
}  // namespace temblor::net
