#include "net/wire/temp_entity.h"

#include <algorithm>

#include "net/wire/message_id.h"

namespace temblor::net {
namespace {

bool is_beam(TempEntityKind kind) {
  return kind == TempEntityKind::kLightning1 || kind == TempEntityKind::kLightning2 ||
         kind == TempEntityKind::kLightning3 || kind == TempEntityKind::kBeam;
}

constexpr std::uint8_t kBloodColor = 73;  // as game code draws it with particle()
constexpr std::uint16_t kMaxBlood = 254;  // svc_particle's most, except for an explosion

// A burst as game code would make it with particle(). Whole units of velocity become its sixteenths.
Particles read_blood(FieldReader& io_fields) {
  Particles blood;
  blood.origin = io_fields.coords();
  for (int axis = 0; axis < 3; ++axis) blood.direction[axis] = static_cast<float>(io_fields.i8()) / 16;
  blood.count = std::min<std::uint16_t>(io_fields.u8(), kMaxBlood);
  blood.color = kBloodColor;
  return blood;
}

void skip_coords(int count, FieldReader& io_fields) {
  for (int i = 0; i < count; ++i) io_fields.coord();
}

void skip_bytes(int count, FieldReader& io_fields) {
  for (int i = 0; i < count; ++i) io_fields.u8();
}

// Reads the fields of kinds that have no counterpart.
void skip_temp_entity(std::uint8_t kind, FieldReader& io_fields) {
  switch (kind) {
    case 51:
      skip_coords(3, io_fields);
      return skip_bytes(4, io_fields);
    case 52:
      skip_coords(7, io_fields);
      return skip_bytes(2, io_fields);
    case 54:
      skip_coords(9, io_fields);
      skip_bytes(4, io_fields);
      return skip_coords(1, io_fields);
    case 55:
    case 56:
      skip_coords(9, io_fields);
      return skip_bytes(3, io_fields);
    case 72:
    case 75:
      return skip_coords(3, io_fields);
    case 73:
      skip_coords(3, io_fields);
      return skip_bytes(5, io_fields);
    case 74:
      skip_coords(6, io_fields);
      return skip_bytes(1, io_fields);
    default:
      io_fields.fail(base::ErrorCode::kUnsupported, "unknown kind of effect {}", kind);
  }
}

}  // namespace

TempEntity read_temp_entity(TempEntityKind kind, FieldReader& io_fields) {
  TempEntity entity;
  entity.kind = kind;
  if (is_beam(entity.kind)) {
    entity.entity = io_fields.entity();
    entity.origin = io_fields.coords();
    entity.end = io_fields.coords();
    return entity;
  }
  entity.origin = io_fields.coords();
  if (entity.kind == TempEntityKind::kExplosion2) {
    entity.color_start = io_fields.u8();
    entity.color_count = io_fields.u8();
  }
  return entity;
}

void write_temp_entity(const TempEntity& message, FieldWriter& io_fields) {
  io_fields.id(MessageId::kTempEntity);
  io_fields.u8(static_cast<std::uint8_t>(message.kind));
  if (is_beam(message.kind)) io_fields.entity(message.entity);
  io_fields.coords(message.origin);
  if (is_beam(message.kind)) io_fields.coords(message.end);
  if (message.kind == TempEntityKind::kExplosion2) {
    io_fields.u8(message.color_start);
    io_fields.u8(message.color_count);
  }
}

ServerMessage read_foreign_temp_entity(std::uint8_t kind, FieldReader& io_fields) {
  TempEntity entity;
  switch (kind) {
    case 50:
      return read_blood(io_fields);
    case 53:
      entity.kind = TempEntityKind::kExplosion;
      entity.origin = io_fields.coords();
      skip_bytes(3, io_fields);
      return entity;
    case 57:
      entity.kind = TempEntityKind::kGunshot;
      break;
    case 58:
      entity.kind = TempEntityKind::kSpike;
      break;
    case 59:
      entity.kind = TempEntityKind::kSuperSpike;
      break;
    case 70:
      entity.kind = TempEntityKind::kExplosion;
      break;
    default:
      skip_temp_entity(kind, io_fields);
      return Ignored{static_cast<std::uint8_t>(MessageId::kTempEntity)};
  }
  entity.origin = io_fields.coords();
  return entity;
}

// The names of achievements begin with these letters. An effect that begins like them would be at a place
// with coordinates of over 2000 and 1000 units, and is worth the risk.
void skip_achievement_or_effect(FieldReader& io_fields) {
  if (io_fields.next_is("ACH_")) {
    io_fields.text("achievement name");
    return;
  }
  skip_coords(3, io_fields);
  skip_bytes(4, io_fields);
}

}  // namespace temblor::net
