#include "support/programs/transcode.h"

#include "formats/game/dem.h"
#include "net/protocol/message_reader.h"
#include "net/protocol/message_writer.h"

namespace temblor::test {

base::Result<base::ByteVector> transcode(base::Bytes dem, const net::Dialect& dialect) {
  TRY(formats::DemReader recording, formats::DemReader::open(dem));
  formats::DemWriter transcoded(recording.forced_track());
  net::MessageReader reader;
  while (true) {
    TRY(const std::optional<formats::DemMessage> packet, recording.next());
    if (!packet) return std::move(transcoded).take();
    reader.begin(packet->message, packet->offset);
    base::ByteWriter writer;
    while (true) {
      TRY(std::optional<net::ServerMessage> message, reader.next());
      if (!message) break;
      if (auto* info = std::get_if<net::ServerInfo>(&*message)) info->dialect = dialect;
      TRY_STATUS(net::write_message(*message, dialect, writer));
    }
    transcoded.add(packet->view_angles_deg, writer.view());
  }
}

}  // namespace temblor::test
