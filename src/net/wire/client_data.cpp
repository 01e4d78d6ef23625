#include "net/wire/client_data.h"

#include <array>

namespace temblor::net {
namespace {

using namespace client_data_flag;

constexpr std::uint32_t kProtocol15Flags =
    0x00ff | kItems | kOnGround | kInWater | kWeaponFrame | kArmor | kWeapon;
constexpr std::uint32_t kProtocol666Flags = kProtocol15Flags | kExtend1 | kWeapon2 | kArmor2 | kAmmo2 |
                                            kShells2 | kNails2 | kRockets2 | kCells2 | kExtend2 |
                                            kWeaponFrame2 | kWeaponAlpha;

// Fields of two bytes. The high bytes follow at the end of the message, in this order.
struct WideField {
  std::uint32_t high_byte_flag;
  std::uint16_t ClientData::*field;
  const char* name;
};
constexpr std::array<WideField, 8> kWideFields = {
    {{kWeapon2, &ClientData::weapon_model, "weapon model"},
     {kArmor2, &ClientData::armor, "armor"},
     {kAmmo2, &ClientData::ammo, "ammo"},
     {kShells2, &ClientData::shells, "shells"},
     {kNails2, &ClientData::nails, "nails"},
     {kRockets2, &ClientData::rockets, "rockets"},
     {kCells2, &ClientData::cells, "cells"},
     {kWeaponFrame2, &ClientData::weapon_frame, "weapon frame"}}};

std::uint32_t read_flags(FieldReader& io_fields) {
  const bool extended = is_extended(io_fields.dialect());
  std::uint32_t flags = io_fields.u16();
  if (extended && (flags & kExtend1)) flags |= std::uint32_t{io_fields.u8()} << 16;
  if (extended && (flags & kExtend2)) flags |= std::uint32_t{io_fields.u8()} << 24;
  io_fields.check_flags(flags, extended ? kProtocol666Flags : kProtocol15Flags);
  return flags;
}

// The values as they appear on the wire. Fields are omitted if they equal the default after rounding.
struct Steps {
  int view_height, ideal_pitch;
  std::array<int, 3> punch, velocity;
};
constexpr int kDefaultViewHeight = 22;

int compute_step8(float value, float unit) {
  return nearest_step(value, 1 / unit, -128, 127);
}

Steps quantize(const ClientData& message) {
  Steps steps{compute_step8(message.view_height, 1), compute_step8(message.ideal_pitch_deg, 1), {}, {}};
  for (int axis = 0; axis < 3; ++axis) {
    steps.punch[static_cast<std::size_t>(axis)] = compute_step8(message.punch_deg[axis], 1);
    steps.velocity[static_cast<std::size_t>(axis)] = compute_step8(message.velocity[axis], kVelocityUnit);
  }
  return steps;
}

// The flags of the third and fourth byte come first, because kExtend1 and kExtend2 depend on whether any of
// those is set.
std::uint32_t compute_flags(const ClientData& message, const Steps& steps, bool extended) {
  std::uint32_t flags = kItems | kWeapon;  // always set, as stock servers do
  if (steps.view_height != kDefaultViewHeight) flags |= kViewHeight;
  if (steps.ideal_pitch != 0) flags |= kIdealPitch;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (steps.punch[axis] != 0) flags |= kPunch[axis];
    if (steps.velocity[axis] != 0) flags |= kVelocity[axis];
  }
  if (message.on_ground) flags |= kOnGround;
  if (message.in_water) flags |= kInWater;
  if (message.weapon_frame != 0) flags |= kWeaponFrame;
  if (message.armor != 0) flags |= kArmor;
  if (extended) {
    for (const WideField& wide : kWideFields)
      if (message.*wide.field > 255) flags |= wide.high_byte_flag;
    if (encode_alpha(message.weapon_alpha) != encode_alpha(1)) flags |= kWeaponAlpha;
  }
  if (flags >> 24) flags |= kExtend2;
  if (flags >> 16) flags |= kExtend1;
  return flags;
}

// Writes the part of the message between items and active weapon, in wire order. Without the flag for its
// high byte, a value over 255 is an error.
void write_low_bytes(const ClientData& message, std::uint32_t flags, FieldWriter& io_fields) {
  const auto low_byte = [&](std::uint16_t ClientData::*field) {
    for (const WideField& wide : kWideFields)
      if (wide.field == field) io_fields.low_byte(message.*field, flags & wide.high_byte_flag, wide.name);
  };
  if (flags & kWeaponFrame) low_byte(&ClientData::weapon_frame);
  if (flags & kArmor) low_byte(&ClientData::armor);
  low_byte(&ClientData::weapon_model);
  io_fields.i16(message.health);
  for (const auto field :
       {&ClientData::ammo, &ClientData::shells, &ClientData::nails, &ClientData::rockets, &ClientData::cells})
    low_byte(field);
}

}  // namespace

// Low bytes come in the middle of the message and high bytes at its end, so wide fields are put together from
// two places.
ClientData read_client_data(FieldReader& io_fields) {
  const std::uint32_t flags = read_flags(io_fields);
  ClientData data;
  if (flags & kViewHeight) data.view_height = io_fields.i8();
  if (flags & kIdealPitch) data.ideal_pitch_deg = io_fields.i8();
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    if (flags & kPunch[i]) data.punch_deg[axis] = io_fields.i8();
    if (flags & kVelocity[i]) data.velocity[axis] = static_cast<float>(io_fields.i8()) * kVelocityUnit;
  }
  data.items = io_fields.u32();
  data.on_ground = flags & kOnGround;
  data.in_water = flags & kInWater;
  if (flags & kWeaponFrame) data.weapon_frame = io_fields.u8();
  if (flags & kArmor) data.armor = io_fields.u8();
  if (flags & kWeapon) data.weapon_model = io_fields.u8();
  data.health = io_fields.i16();
  data.ammo = io_fields.u8();
  data.shells = io_fields.u8();
  data.nails = io_fields.u8();
  data.rockets = io_fields.u8();
  data.cells = io_fields.u8();
  data.active_weapon = io_fields.u8();
  for (const WideField& wide : kWideFields)
    if (flags & wide.high_byte_flag)
      data.*wide.field = static_cast<std::uint16_t>(data.*wide.field | io_fields.u8() << 8);
  if (flags & kWeaponAlpha) data.weapon_alpha = decode_alpha(io_fields.u8());
  return data;
}

void write_client_data(const ClientData& message, FieldWriter& io_fields) {
  const Steps steps = quantize(message);
  const std::uint32_t flags = compute_flags(message, steps, is_extended(io_fields.dialect()));
  const auto i8 = [&](int value) { io_fields.i8(static_cast<std::int8_t>(value)); };
  io_fields.id(MessageId::kClientData);
  io_fields.u16(static_cast<std::uint16_t>(flags));
  if (flags & kExtend1) io_fields.u8(static_cast<std::uint8_t>(flags >> 16));
  if (flags & kExtend2) io_fields.u8(static_cast<std::uint8_t>(flags >> 24));
  if (flags & kViewHeight) i8(steps.view_height);
  if (flags & kIdealPitch) i8(steps.ideal_pitch);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (flags & kPunch[axis]) i8(steps.punch[axis]);
    if (flags & kVelocity[axis]) i8(steps.velocity[axis]);
  }
  io_fields.u32(message.items);
  write_low_bytes(message, flags, io_fields);
  io_fields.u8(message.active_weapon);
  for (const WideField& wide : kWideFields)
    if (flags & wide.high_byte_flag) io_fields.u8(static_cast<std::uint8_t>(message.*wide.field >> 8));
  if (flags & kWeaponAlpha) io_fields.u8(encode_alpha(message.weapon_alpha));
}

}  // namespace temblor::net
