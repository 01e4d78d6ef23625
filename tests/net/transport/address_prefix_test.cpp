#include "net/transport/admission/address_prefix.h"

#include <gtest/gtest.h>

namespace temblor::net {
namespace {

platform::Address at(const char* host) {
  return platform::parse_host(host, 26000).value();
}

TEST(AddressPrefix, ContainsExactlyItsNetwork) {
  const AddressPrefix net = *parse_prefix("192.0.2.77/24");
  EXPECT_TRUE(net.contains(at("192.0.2.0")));
  EXPECT_TRUE(net.contains(at("192.0.2.255")));
  EXPECT_FALSE(net.contains(at("192.0.3.0")));
  EXPECT_EQ(to_text(net), "192.0.2.0/24");
  const AddressPrefix odd = *parse_prefix("10.16.0.0/13");
  EXPECT_TRUE(odd.contains(at("10.23.255.255")));
  EXPECT_FALSE(odd.contains(at("10.24.0.0")));
  const AddressPrefix wide = *parse_prefix("2001:db8::/33");
  EXPECT_TRUE(wide.contains(at("2001:db8:7fff::1")));
  EXPECT_FALSE(wide.contains(at("2001:db8:8000::1")));
}

TEST(AddressPrefix, WithoutMaskIsOneHost) {
  const AddressPrefix one = *parse_prefix("192.0.2.1");
  EXPECT_TRUE(one.contains(at("192.0.2.1")));
  EXPECT_FALSE(one.contains(at("192.0.2.2")));
  EXPECT_EQ(to_text(one), "192.0.2.1");
  EXPECT_EQ(one, *parse_prefix("192.0.2.1/32"));
}

TEST(AddressPrefix, ZeroBitsContainWholeAddressFamily) {
  EXPECT_TRUE(parse_prefix("0.0.0.0/0")->contains(at("255.1.2.3")));
  EXPECT_FALSE(parse_prefix("0.0.0.0/0")->contains(at("2001:db8::1")));
  EXPECT_TRUE(parse_prefix("::/0")->contains(at("1.2.3.4")));
  for (const char* text : {"0.0.0.0/0", "::/0", "2001:db8::/32", "10.0.0.0/8", "2001:db8::1"})
    EXPECT_EQ(to_text(*parse_prefix(text)), text);
}

TEST(AddressPrefix, RejectsInvalidTextWithReason) {
  for (const char* text : {"", "quake.example", "1.2.3", "/24"})
    EXPECT_NE(parse_prefix(text).error().message().find("is not a numeric IP address"), std::string::npos)
        << text;
  for (const char* text : {"1.2.3.4/", "1.2.3.4/33", "1.2.3.4/-1", "1.2.3.4/x", "1.2.3.4/8x"})
    EXPECT_NE(parse_prefix(text).error().message().find("must be a number from 0 to 32"), std::string::npos)
        << text;
  EXPECT_FALSE(parse_prefix("::1/129").ok());
}

}  // namespace
}  // namespace temblor::net
