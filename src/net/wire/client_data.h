// Wire format of svc_clientdata, the player's own state in every snapshot: flags, then the fields that differ
// from their defaults. Protocols 666 and 999 append high bytes for values over 255.
//
//   flags u16 [u8 [u8]] | [view height i8] [ideal pitch i8] | 3 x ([punch i8] [velocity i8]) | items u32 |
//   [weapon frame u8] [armor u8] [weapon model u8] | health i16 | ammo, shells, nails, rockets, cells u8 |
//   active weapon u8 | [high bytes, in the order of their flags] | [weapon alpha u8]
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
  kItems = 1u << 9,  // the field is always present, even if this is clear
  kOnGround = 1u << 10,
  kInWater = 1u << 11,
  kWeaponFrame = 1u << 12,
  kArmor = 1u << 13,
  kWeapon = 1u << 14,
  kExtend1 = 1u << 15,  // a third byte of flags follows
  // High bytes of the fields with these names follow.
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
// For the three axes.
constexpr std::array<std::uint32_t, 3> kPunch = {1u << 2, 1u << 3, 1u << 4};
constexpr std::array<std::uint32_t, 3> kVelocity = {1u << 5, 1u << 6, 1u << 7};
}  // namespace client_data_flag

// Fields that the message omits keep the defaults of ClientData.
ClientData read_client_data(FieldReader& io_fields);
// Rounds and clamps punch angles, velocities, and view heights to their bytes. Protocol 15 has one byte for
// armor, ammunition, and model numbers; greater values are errors there.
void write_client_data(const ClientData& message, FieldWriter& io_fields);

}  // namespace temblor::net
