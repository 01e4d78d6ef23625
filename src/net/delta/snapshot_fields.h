// The fields of entity updates and of client data as words, and back: numbers as they are sent, none rounded.
#pragma once

#include <cstdint>
#include <span>

#include "base/bytes.h"
#include "net/protocol/protocol.h"

namespace temblor::net {

// `words`: SnapshotState::kEntityWords, and the entity's number apart. False where these bytes are no whole
// message, or not one that would be written so.
bool read_entity_words(base::Bytes message, const Dialect& dialect, std::uint16_t& out_number,
                       std::span<std::uint32_t> out_words);
void write_entity_words(std::uint16_t number, std::span<const std::uint32_t> words, const Dialect& dialect,
                        base::ByteWriter& io_writer);

// SnapshotState::kClientDataWords.
bool read_client_data_words(base::Bytes message, const Dialect& dialect, std::span<std::uint32_t> out_words);
void write_client_data_words(std::span<const std::uint32_t> words, const Dialect& dialect,
                             base::ByteWriter& io_writer);

}  // namespace temblor::net
