// Control packets: read and written byte by byte as the protocol description has them, and rejected ones.
#include "net/transport/control.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "support/effort.h"
#include "support/mutations.h"

namespace temblor::net {
namespace {

using base::ErrorCode;
using ::testing::HasSubstr;
using namespace std::string_literals;

base::ByteVector written(const ControlPacket& packet) {
  auto bytes = write_control_packet(packet);
  EXPECT_TRUE(bytes.ok()) << bytes.error().message();
  return std::move(bytes).value();
}

// `body`: from the command byte.
base::ByteVector control(std::string_view body) {
  return test::to_bytes("\x80\0"s + static_cast<char>((body.size() + 4) >> 8) +
                        static_cast<char>(body.size() + 4) + std::string(body));
}

struct Case {
  ControlPacket packet;
  std::string body;
};

std::vector<Case> cases() {
  return {{ConnectRequest{}, "\x01QUAKE\0\x03"s},
          {ServerInfoRequest{}, "\x02QUAKE\0\x03"s},
          {PlayerInfoRequest{7}, "\x03\x07"s},
          {RuleInfoRequest{""}, "\x04\0"s},
          {RuleInfoRequest{"sv_gravity"}, "\x04sv_gravity\0"s},
          {RemoteCommandRequest{"secret", "map e1m1"}, "\x05secret\0map e1m1\0"s},
          {AcceptReply{26000}, "\x81\x90\x65\0\0"s},
          {RejectReply{"full"},
           "\x82"
           "full\0"s},
          {ServerInfoReply{"1.2.3.4:26000", "a host", "dm1", 3, 16, 3},
           "\x83"
           "1.2.3.4:26000\0a host\0dm1\0\x03\x10\x03"s},
          {PlayerInfoReply{1, "bob", 0x4d, -2, 300, "x"},
           "\x84\x01"
           "bob\0\x4d\0\0\0\xfe\xff\xff\xff\x2c\x01\0\0x\0"s},
          {RuleInfoReply{"fraglimit", "20"},
           "\x85"
           "fraglimit\0"
           "20\0"s},
          {RuleInfoReply{}, "\x85"s},
          {RemoteCommandReply{"done\n"},
           "\x86"
           "done\n\0"s}};
}

TEST(Control, BytesMatchDescription) {
  for (const Case& c : cases()) EXPECT_EQ(written(c.packet), control(c.body)) << packet_name(c.packet);
  EXPECT_EQ(written(ServerInfoRequest{}).size(), 12u);
}

TEST(Control, RoundTrips) {
  for (const Case& c : cases()) {
    const base::ByteVector bytes = control(c.body);
    const auto read = read_control_packet(bytes);
    ASSERT_TRUE(read.ok()) << read.error().message();
    EXPECT_EQ(read->index(), c.packet.index());
    EXPECT_EQ(written(*read), bytes) << packet_name(c.packet);
  }
}

TEST(Control, IgnoresExtraBytes) {
  for (const Case& c : cases()) {
    if (c.body.size() == 1) continue;  // extra bytes would turn the end of the rules into a rule
    const base::ByteVector bytes = control(c.body + "\x01\x22more");
    const auto read = read_control_packet(bytes);
    ASSERT_TRUE(read.ok()) << read.error().message();
    EXPECT_EQ(written(*read), control(c.body)) << packet_name(c.packet);
  }
}

std::string control_error(base::Bytes bytes) {
  const auto read = read_control_packet(bytes);
  return read.ok() ? "no error" : read.error().message();
}

TEST(BadControl, IsRejectedWithReason) {
  EXPECT_EQ(control_error({}), "not a control packet (0 bytes)");
  EXPECT_EQ(control_error(test::to_bytes("\x80\0\0\x04"s)), "not a control packet (4 bytes)");
  EXPECT_EQ(control_error(test::to_bytes("\0\0\0\x05\x01"s)), "not a control packet (5 bytes)");
  EXPECT_EQ(control_error(test::to_bytes("\x80\0\0\x06\x01"s)),
            "control packet of 5 bytes has the header 0x80000006");
  EXPECT_EQ(control_error(test::to_bytes("\x80\x01\0\x05\x01"s)),
            "control packet of 5 bytes has the header 0x80010005");
  EXPECT_EQ(control_error(control("\x06")), "unknown control command 0x6");
  EXPECT_EQ(control_error(control("\x01HEXEN\0\x03"s)), "CCREQ_CONNECT: game is 'HEXEN', expected 'QUAKE'");
  EXPECT_EQ(control_error(control("\x01QUAKE\0"s)), "CCREQ_CONNECT: packet ends after 11 bytes");
  EXPECT_EQ(control_error(control("\x01QUAKE"s)), "CCREQ_CONNECT: game name has no terminating zero");
  EXPECT_EQ(control_error(control("\x85rule\0x"s)), "CCREP_RULE_INFO: value has no terminating zero");
}

TEST(BadControl, RejectsEveryTruncation) {
  for (const Case& c : cases())
    for (std::size_t size = 1; size < c.body.size(); ++size) {
      const std::string cut = c.body.substr(0, size);
      const bool is_end_of_rules = cut == "\x85";
      EXPECT_EQ(control_error(control(cut)) == "no error", is_end_of_rules) << packet_name(c.packet) << size;
    }
}

TEST(BadControl, RejectsUnrepresentableTexts) {
  EXPECT_EQ(write_control_packet(RejectReply{{"a\0b", 3}}).error().code, ErrorCode::kTooLarge);
  EXPECT_THAT(write_control_packet(RejectReply{std::string(1400, 'x')}).error().message(),
              HasSubstr("CCREP_REJECT: 1406 bytes exceed the limit of 1400"));
}

TEST(BadControl, SurvivesRandomBytes) {
  test::Random random(1);
  const std::vector<Case> all = cases();
  for (int i = 0; i < test::effort(50000, 5000); ++i) {
    const base::ByteVector good = control(all[random.below(all.size())].body);
    const base::ByteVector bytes = random.chance(0.5) ? test::with_flipped_bits(good, random)
                                                      : test::random_bytes(random, random.below(30));
    const auto read = read_control_packet(bytes);
    ASSERT_TRUE(!read.ok() || written(*read).size() <= bytes.size());
  }
}

}  // namespace
}  // namespace temblor::net
