#include "net/transport/admission/challenge.h"

#include <gtest/gtest.h>

#include <array>
#include <set>

namespace temblor::net {
namespace {

// Test vector of the paper (appendix A): key 00 01 .. 0f, input 00 01 .. 0e.
TEST(Challenge, SipHashMatchesPaper) {
  base::ByteVector input;
  for (int i = 0; i < 15; ++i) input.push_back(static_cast<std::byte>(i));
  EXPECT_EQ(sip_hash({0x0706050403020100u, 0x0f0e0d0c0b0a0908u}, input), 0xa129ca6149be45e5u);
}

TEST(Challenge, CookiesAreUnique) {
  std::set<std::string> words;
  for (const Secret& secret : {Secret{1, 2}, Secret{1, 3}, Secret{2, 2}})
    for (std::uint16_t port = 1; port <= 100; ++port)
      for (std::uint64_t serial = 0; serial < 3; ++serial)
        for (const std::uint8_t host : std::array<std::uint8_t, 2>{1, 2}) {
          const auto address = platform::ip4_address({10, 0, 0, host}, port);
          const std::string word = make_challenge_cookie(secret, address, serial);
          EXPECT_EQ(word.size(), 10u);
          EXPECT_EQ(word, make_challenge_cookie(secret, address, serial));
          words.insert(word);
        }
  EXPECT_EQ(words.size(), 3u * 100 * 3 * 2);
}

}  // namespace
}  // namespace temblor::net
