// Entity updates ("fast updates"): only what differs from the entity's baseline.
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
  kSignal = 1u << 7,  // tells an update's first byte from other messages' numbers
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
constexpr std::array<std::uint32_t, 3> kOrigin = {1u << 1, 1u << 2, 1u << 3};
constexpr std::array<std::uint32_t, 3> kAngle = {1u << 8, 1u << 4, 1u << 9};
}  // namespace entity_flag

// `id` is the message's first byte, 128 or more: it holds the first flags.
EntityUpdate read_entity_update(std::uint8_t id, FieldReader& io_fields);

// With the first byte. What protocol 15 has no words for (opacity, scale, time of the next frame) is left
// out.
void write_entity_update(const EntityUpdate& update, FieldWriter& io_fields);

}  // namespace temblor::net
