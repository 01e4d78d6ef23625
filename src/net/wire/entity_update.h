// Wire format of entity updates ("fast updates"), which contain only the fields that differ from the entity's
// baseline. The first byte has bit 7 set, so it is both the message number and the first byte of the flags.
//
//   flags u8 [u8 [u8 [u8]]] | number u8/u16 | [model u8] [frame u8] [colormap u8] [skin u8] [effects u8] |
//   3 x ([coord] [angle]) | [alpha u8] [scale u8] [frame high u8] [model high u8] [lerp finish u8]
#pragma once

#include <array>
#include <cstdint>

#include "net/protocol/server_message.h"
#include "net/wire/field_reader.h"
#include "net/wire/field_writer.h"

namespace temblor::net {

namespace entity_flag {
enum : std::uint32_t {
  kMoreBits = 1u << 0,  // a second byte of flags follows
  kStep = 1u << 5,
  kFrame = 1u << 6,
  kSignal = 1u << 7,  // always set: distinguishes an update from other messages
  kModel = 1u << 10,
  kColormap = 1u << 11,
  kSkin = 1u << 12,
  kEffects = 1u << 13,
  kLongEntity = 1u << 14,
  kExtend1 = 1u << 15,  // a third byte of flags follows
  kAlpha = 1u << 16,
  kFrame2 = 1u << 17,  // the high byte
  kModel2 = 1u << 18,  // the high byte
  kLerpFinish = 1u << 19,
  kScale = 1u << 20,
  kExtend2 = 1u << 23,  // a fourth byte of flags follows
};
// For the three axes.
constexpr std::array<std::uint32_t, 3> kOrigin = {1u << 1, 1u << 2, 1u << 3};
constexpr std::array<std::uint32_t, 3> kAngle = {1u << 8, 1u << 4, 1u << 9};
}  // namespace entity_flag

// `id`: the first byte of the message (at least 128), which the caller has read already.
EntityUpdate read_entity_update(std::uint8_t id, FieldReader& io_fields);

// Writes the whole message. In protocol 15, omits alpha, scale, and the time of the next frame.
void write_entity_update(const EntityUpdate& update, FieldWriter& io_fields);

}  // namespace temblor::net
