// Wire format of svc_temp_entity, short effects without an entity:
//
//   kind u8 | 3 coords                          most kinds
//   kind u8 | entity u16 | 3 coords | 3 coords  beams: start and end
//   kind u8 | 3 coords | u8 | u8                kExplosion2: first palette color and number of colors
#pragma once

#include "net/protocol/server_message.h"
#include "net/wire/field_reader.h"
#include "net/wire/field_writer.h"

namespace temblor::net {

TempEntity read_temp_entity(FieldReader& io_fields);
void write_temp_entity(const TempEntity& message, FieldWriter& io_fields);

}  // namespace temblor::net
