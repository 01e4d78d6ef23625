// Bits of net::ClientData::items for power-ups; stock Quake's IT_ constants.
#pragma once

#include <cstdint>

namespace temblor::client {

enum PowerupItems : std::uint32_t {
  kItemInvisibility = 1u << 19,     // ring of shadows
  kItemInvulnerability = 1u << 20,  // pentagram of protection
  kItemSuit = 1u << 21,             // biosuit
  kItemQuad = 1u << 22              // quad damage
};

}  // namespace temblor::client
