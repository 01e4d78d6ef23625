#include "server/builtins/text/player_text.h"

namespace temblor::server {

void write_center_text(std::string_view text, Outbox& io_outbox, base::ByteWriter& io_writer) {
  io_outbox.write(net::CenterPrint{text.substr(0, kMaxTextBytes)}, io_writer);
}

base::Result<base::ByteWriter*> player_buffer(Call& io_call) {
  TRY(const vm::EntityIndex entity, io_call.entity(0));
  base::ByteWriter* const writer = io_call.game.outbox.reliable_to(entity);
  if (writer == nullptr)
    io_call.warn_once(fmt::format("entity {} is not a player: it gets no text", base::to_size(entity)));
  return writer;
}

}  // namespace temblor::server
