// Wire format of svc_serverinfo, the first message of a level:
//
//   protocol i32 | [flags u32, protocol 999 only] | max clients u8 | game type u8 | level name |
//   model names, then "" | sound names, then ""           (texts end with a zero byte)
#pragma once

#include <string_view>
#include <vector>

#include "net/protocol/server_message.h"
#include "net/wire/field_reader.h"
#include "net/wire/field_writer.h"

namespace temblor::net {

// Fills `out_models` and `out_sounds` with the precache lists; the result refers to them.
ServerInfo read_server_info(FieldReader& io_fields, std::vector<std::string_view>& out_models,
                            std::vector<std::string_view>& out_sounds);
// Writes the dialect of the message itself, not that of `io_fields`.
void write_server_info(const ServerInfo& message, FieldWriter& io_fields);

}  // namespace temblor::net
