// Converts entity updates and client data between messages and arrays of 32-bit words, one for each field,
// without any rounding: the same words always give the same message bytes. Signed fields are sign-extended,
// so that small changes stay small differences. snapshot_state.h explains the layout.
#pragma once

#include <cstdint>
#include <span>

#include "base/bytes.h"
#include "net/protocol/protocol.h"

namespace temblor::net {

// Entity updates: SnapshotState::kEntityWords words, and the entity number apart. Reading returns false if
// the bytes are not exactly one message that write_entity_words() can restore.
bool read_entity_words(base::Bytes message, const Dialect& dialect, std::uint16_t& out_number,
                       std::span<std::uint32_t> out_words);
void write_entity_words(std::uint16_t number, std::span<const std::uint32_t> words, const Dialect& dialect,
                        base::ByteWriter& io_writer);

// Client data: SnapshotState::kClientDataWords words; otherwise as above.
bool read_client_data_words(base::Bytes message, const Dialect& dialect, std::span<std::uint32_t> out_words);
void write_client_data_words(std::span<const std::uint32_t> words, const Dialect& dialect,
                             base::ByteWriter& io_writer);

}  // namespace temblor::net
