#include "net/wire/temp_entity.h"

namespace temblor::net {
namespace {

bool is_beam(TempEntityKind kind) {
  return kind == TempEntityKind::kLightning1 || kind == TempEntityKind::kLightning2 ||
         kind == TempEntityKind::kLightning3 || kind == TempEntityKind::kBeam;
}

}  // namespace

// An unknown kind is an error, because the length of its message is unknown.
TempEntity read_temp_entity(FieldReader& io_fields) {
  const std::uint8_t number = io_fields.u8();
  constexpr auto kLast = static_cast<std::uint8_t>(TempEntityKind::kBeam);
  if (number > kLast)
    io_fields.fail(base::ErrorCode::kUnsupported,
                   "temporary entity {} is not supported; supported are 0 to {}", number, kLast);
  TempEntity entity;
  entity.kind = TempEntityKind{number};
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

}  // namespace temblor::net
