// Feeds arbitrary bytes to the reader of client messages, in the protocol that the first byte chooses. Each
// message that is read must be written and read back unchanged, up to an error or the end.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/check.h"
#include "fuzz/targets.h"
#include "net/protocol/client_message.h"

using namespace temblor;

int temblor::fuzz::fuzz_client_message(const std::uint8_t* data, std::size_t size) {
  if (size < 1) return 0;
  constexpr net::Protocol kProtocols[] = {net::Protocol::kNetQuake, net::Protocol::kFitzQuake,
                                          net::Protocol::kRmq};
  const net::Protocol protocol = kProtocols[data[0] % 3];
  const base::Bytes bytes = std::as_bytes(std::span(data, size).subspan(1));
  net::ClientMessageReader reader(bytes, protocol);
  base::ByteWriter again;
  while (true) {
    const auto message = reader.next();
    if (!message.ok() || !message->has_value()) break;
    const base::Status status = net::write_client_message(**message, protocol, again);
    CHECK(status.ok(), "{}", status.error().message());
  }
  CHECK(again.size() <= bytes.size());
  CHECK(std::equal(again.view().begin(), again.view().end(), bytes.begin()));
  return 0;
}
