// Temporary entities: things that happen at a place and leave nothing behind.
#pragma once

#include "net/protocol/server_message.h"
#include "net/wire/field_reader.h"
#include "net/wire/field_writer.h"

namespace temblor::net {

TempEntity read_temp_entity(FieldReader& io_fields);
void write_temp_entity(const TempEntity& message, FieldWriter& io_fields);

}  // namespace temblor::net
