// Tests conversions between addresses and text.
#include "platform/address.h"

#include <gtest/gtest.h>

#include <string>

namespace temblor::platform {
namespace {

TEST(Address, PrintsInCommonNotation) {
  EXPECT_EQ(to_text(ip4_address({192, 0, 2, 1}, 26000)), "192.0.2.1:26000");
  EXPECT_EQ(to_text(Address{}), "local:0");
  const std::optional<Address> ip6 = parse_host("2001:db8::1", 7);
  ASSERT_TRUE(ip6);
  EXPECT_EQ(to_text(*ip6), "[2001:db8::1]:7");
  EXPECT_EQ(host_text(*ip6), "2001:db8::1");
}

TEST(Address, MappedIp4EqualsIp4) {
  EXPECT_EQ(parse_host("::ffff:10.1.2.3", 5), ip4_address({10, 1, 2, 3}, 5));
  EXPECT_EQ(parse_host("10.1.2.3", 5), ip4_address({10, 1, 2, 3}, 5));
  EXPECT_TRUE(parse_host("10.1.2.3", 5)->is_ip4());
  EXPECT_FALSE(parse_host("::1", 5)->is_ip4());
  EXPECT_TRUE(parse_host("10.1.2.3", 5)->same_host(*parse_host("10.1.2.3", 6)));
  EXPECT_NE(parse_host("10.1.2.3", 5), parse_host("10.1.2.3", 6));
}

TEST(Address, ParseHostRejectsNamesAndBadNumbers) {
  for (const std::string text : {"", "localhost", "1.2.3", "1.2.3.256", "1.2.3.4:5", "[::1]", "::g"})
    EXPECT_FALSE(parse_host(text, 1)) << text;
  EXPECT_FALSE(parse_host(std::string_view("1.2.3.4\0x", 9), 1));
}

TEST(Address, SplitsHostAndPort) {
  struct Case {
    const char* text;
    const char* host;
    std::optional<std::uint16_t> port;
  };
  for (const Case& c :
       {Case{"quake.example", "quake.example", {}}, Case{"quake.example:27", "quake.example", 27},
        Case{"1.2.3.4:65535", "1.2.3.4", 65535}, Case{"[::1]:26000", "::1", 26000}, Case{"[::1]", "::1", {}},
        Case{"fe80::1", "fe80::1", {}}, Case{"::1:26000", "::1:26000", {}}}) {
    const auto parts = split_host_and_port(c.text);
    ASSERT_TRUE(parts.ok()) << c.text;
    EXPECT_EQ(parts->host, c.host);
    EXPECT_EQ(parts->port, c.port);
  }
}

TEST(Address, ErrorsNameTheBadPart) {
  for (const char* text : {"host:", "host:0", "host:65536", "host:-1", "host:1x", "[::1]:"}) {
    const auto parts = split_host_and_port(text);
    ASSERT_FALSE(parts.ok()) << text;
    EXPECT_NE(parts.error().message().find("is not a number from 1 to 65535"), std::string::npos) << text;
  }
  for (const char* text : {"", ":1", "[]", "[::1", "[::1]x", "[]:1"})
    EXPECT_FALSE(split_host_and_port(text).ok()) << text;
}

}  // namespace
}  // namespace temblor::platform
