// What the player's own status bar, weapon and view need: one in every update.
#pragma once

#include "net/server_message.h"
#include "net/wire/field_reader.h"
#include "net/wire/field_writer.h"

namespace temblor::net {

ClientData read_client_data(FieldReader& io_fields);
// Kicks, speeds and heights of view are rounded into the range of their byte.
void write_client_data(const ClientData& message, FieldWriter& io_fields);

}  // namespace temblor::net
