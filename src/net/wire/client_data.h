// What the player's own status bar, weapon and view need: one in every update.
#pragma once

#include <array>
#include <cstdint>

#include "net/protocol/server_message.h"
#include "net/wire/field_reader.h"
#include "net/wire/field_writer.h"

namespace temblor::net {

namespace client_data_flag {
enum : std::uint32_t {
  kViewHeight = 1u << 0,
  kIdealPitch = 1u << 1,
  kItems = 1u << 9,  // the field is there even without it
  kOnGround = 1u << 10,
  kInWater = 1u << 11,
  kWeaponFrame = 1u << 12,
  kArmor = 1u << 13,
  kWeapon = 1u << 14,
  kExtend1 = 1u << 15,  // a third byte of flags follows
  // High bytes of the fields of the same names.
  kWeapon2 = 1u << 16,
  kArmor2 = 1u << 17,
  kAmmo2 = 1u << 18,
  kShells2 = 1u << 19,
  kNails2 = 1u << 20,
  kRockets2 = 1u << 21,
  kCells2 = 1u << 22,
  kExtend2 = 1u << 23,  // a fourth byte of flags follows
  kWeaponFrame2 = 1u << 24,
  kWeaponAlpha = 1u << 25,
};
constexpr std::array<std::uint32_t, 3> kPunch = {1u << 2, 1u << 3, 1u << 4};
constexpr std::array<std::uint32_t, 3> kVelocity = {1u << 5, 1u << 6, 1u << 7};
}  // namespace client_data_flag

ClientData read_client_data(FieldReader& io_fields);
// Kicks, speeds and heights of view are rounded into the range of their byte.
void write_client_data(const ClientData& message, FieldWriter& io_fields);

}  // namespace temblor::net
