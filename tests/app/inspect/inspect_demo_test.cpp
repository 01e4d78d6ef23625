// `inspect` of demos that are generated here.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "app/inspect/inspection.h"
#include "formats/game/dem.h"
#include "net/protocol/message_writer.h"
#include "support/game_data.h"
#include "support/mutations.h"

namespace temblor::app {
namespace {

using ::testing::HasSubstr;

constexpr net::Dialect k999{net::Protocol::kRmq, net::kInt32Coord | net::kShortAngle};

base::ByteVector packet(const std::vector<net::ServerMessage>& messages, const net::Dialect& dialect = {}) {
  base::ByteWriter writer;
  for (const net::ServerMessage& message : messages)
    EXPECT_TRUE(net::write_message(message, dialect, writer).ok());
  return std::move(writer).take();
}

// A demo of two levels: 2.5 s in protocol 999, then 1 s.
base::ByteVector two_levels(int forced_track = 4) {
  const std::array<std::string_view, 2> models = {"maps/a.bsp", "*1"};
  const std::array<std::string_view, 1> other_models = {"maps/b.bsp"};
  formats::DemWriter writer(forced_track);
  writer.add({}, packet({net::ServerInfo{k999, 2, 0, "First", models}, net::UpdateName{0, "Ranger"}}, k999));
  writer.add({}, packet({net::Time{10}, net::UpdateName{1, "\xc5va"}, net::UpdateName{0, "Ranger"}}, k999));
  writer.add({}, packet({net::Time{12.5f}, net::SetAngle{}}, k999));
  writer.add({}, packet({net::ServerInfo{{}, 2, 0, "Second", other_models}}));
  writer.add({}, packet({net::Time{1}}));
  writer.add({}, packet({net::Time{2}, net::UpdateName{0, ""}}));
  writer.add({}, packet({net::Disconnect{}}));
  return std::move(writer).take();
}

TEST(InspectDemo, ListsTheContents) {
  const auto result = inspect_dem(two_levels());
  ASSERT_TRUE(result.ok()) << result.error().message();
  const Inspection expected = {
      {"forced track", 4},
      {"protocol", 999},
      {"protocol flags", {"SHORTANGLE", "INT32COORD"}},
      {"level", "First"},
      {"level file", "maps/a.bsp"},
      {"further levels", {{{"level", "Second"}, {"file", "maps/b.bsp"}, {"seconds", 1.0}}}},
      {"seconds", 3.5},
      {"packets", 7},
      {"players", {"Ranger", "Eva"}},
      {"messages",
       {{"svc_disconnect", 1},
        {"svc_serverinfo", 2},
        {"svc_setangle", 1},
        {"svc_time", 4},
        {"svc_updatename", 4}}},
      {"problems", Inspection::array()}};
  EXPECT_EQ(result->dump(2), expected.dump(2));
}

TEST(InspectDemo, TruncatedDemo) {
  const base::ByteVector whole = two_levels();
  const auto result = inspect_dem(base::Bytes(whole).first(whole.size() - 1));
  ASSERT_TRUE(result.ok()) << result.error().message();
  EXPECT_EQ(result->at("packets"), 6);
  EXPECT_EQ(result->at("seconds"), 3.5);
  // The last packet is a length, three angles, and one byte.
  EXPECT_EQ(result->at("problems").dump(), "[\"truncated: the last packet, at offset " +
                                               std::to_string(whole.size() - 17) + ", is incomplete\"]");
}

TEST(InspectDemo, UnreadableMessage) {
  formats::DemWriter writer;
  writer.add({}, packet({net::ServerInfo{.level_name = "x"}, net::Time{1}}));
  writer.add({}, base::as_bytes("\x07"));
  writer.add({}, packet({net::Time{3}}));
  writer.add({}, base::as_bytes("\x4d"));
  const base::ByteVector bytes = std::move(writer).take();
  const auto result = inspect_dem(bytes);
  ASSERT_TRUE(result.ok()) << result.error().message();
  EXPECT_EQ(result->at("seconds"), 2.0);
  EXPECT_EQ(result->at("messages").at("svc_time"), 2);
  const std::string problems = result->at("problems").dump();
  const std::size_t offset = bytes.size() - 17 - 21 - 1;
  EXPECT_THAT(problems, HasSubstr("2 of 4 packets damaged; the first: offset " + std::to_string(offset) +
                                  ": svc_time: message ends after 1 of 5 bytes"));
  EXPECT_THAT(problems, HasSubstr("ends without svc_disconnect"));
}

TEST(InspectDemo, PacketOfInvalidLength) {
  base::ByteVector bytes = two_levels();
  const base::Bytes more = base::as_bytes("\xff\xff\xff\x7f and so on");
  bytes.insert(bytes.end(), more.begin(), more.end());
  const auto result = inspect_dem(bytes);
  ASSERT_TRUE(result.ok()) << result.error().message();
  EXPECT_EQ(result->at("packets"), 7);
  EXPECT_THAT(result->at("problems").dump(), HasSubstr("the rest cannot be read: message at offset"));
  // Without any packet before it, the file is an error.
  EXPECT_FALSE(inspect_dem(base::as_bytes("-1\n\xff\xff\xff\x7f and so on")).ok());
  EXPECT_FALSE(inspect_dem(base::as_bytes("this is not a demo")).ok());
  EXPECT_FALSE(inspect_dem(base::as_bytes("this is\nnot a demo, but text")).ok());
}

TEST(InspectDemo, NoLevel) {
  const auto result = inspect_dem(base::as_bytes("-1\n"));
  ASSERT_TRUE(result.ok());
  EXPECT_EQ(result->at("packets"), 0);
  EXPECT_THAT(result->at("problems").dump(), HasSubstr("no svc_serverinfo"));
}

TEST(InspectDemo, FlippedBitsAreReported) {
  const base::ByteVector whole = two_levels();
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    test::Random random(seed);
    const auto result = inspect_dem(test::with_flipped_bits(whole, random));
    const std::string said = result.ok() ? describe_inspection(*result) : result.error().message();
    EXPECT_FALSE(said.empty()) << "seed " << seed;
  }
}

TEST(InspectDemo, StockDemos) {
  DATA_FOLDER_OR_SKIP(folder);
  const auto lite = inspect_file(folder / "id1/demo1_lite.dem");
  ASSERT_TRUE(lite.ok()) << lite.error().message();
  EXPECT_EQ(lite->at("format"), "demo");
  EXPECT_EQ(lite->at("protocol"), 15);
  EXPECT_EQ(lite->at("level"), "Baseless Base Banter");
  EXPECT_EQ(lite->at("level file"), "maps/lq_e0m1.bsp");
  EXPECT_NEAR(lite->at("seconds").get<double>(), 60, 1);
  EXPECT_TRUE(lite->at("problems").empty()) << lite->at("problems");
  const auto rmq = inspect_file(folder / "id1/demo3.dem");
  ASSERT_TRUE(rmq.ok()) << rmq.error().message();
  EXPECT_EQ(rmq->at("protocol"), 999);
  EXPECT_EQ(rmq->at("protocol flags").dump(), R"(["SHORTANGLE","INT32COORD"])");
  EXPECT_EQ(rmq->at("level"), "Hyperborea");
  EXPECT_TRUE(rmq->at("problems").empty()) << rmq->at("problems");
}

}  // namespace
}  // namespace temblor::app
