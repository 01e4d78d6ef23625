// The first message of a game: which protocol is spoken, and what models and sounds there are.
#pragma once

#include <string_view>
#include <vector>

#include "net/protocol/server_message.h"
#include "net/wire/field_reader.h"
#include "net/wire/field_writer.h"

namespace temblor::net {

// The precache lists are read into `out_models` and `out_sounds`, to which the result refers.
ServerInfo read_server_info(FieldReader& io_fields, std::vector<std::string_view>& out_models,
                            std::vector<std::string_view>& out_sounds);
// Announces the message's own dialect.
void write_server_info(const ServerInfo& message, FieldWriter& io_fields);

}  // namespace temblor::net
