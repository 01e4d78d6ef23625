// Entity updates ("fast updates"): only what differs from the entity's baseline.
#pragma once

#include <cstdint>

#include "net/server_message.h"
#include "net/wire/field_reader.h"
#include "net/wire/field_writer.h"

namespace temblor::net {

// `id` is the message's first byte, 128 or more: it holds the first flags.
EntityUpdate read_entity_update(std::uint8_t id, FieldReader& io_fields);

// With the first byte. What protocol 15 has no words for (opacity, scale, time of the next frame) is left
// out.
void write_entity_update(const EntityUpdate& update, FieldWriter& io_fields);

}  // namespace temblor::net
