#include "net/protocol/demo_writer.h"

#include "base/check.h"
#include "net/protocol/message_writer.h"

namespace temblor::net {

void DemoWriter::add(const math::Vec3& view_angles_deg, base::Bytes messages) {
  // A client cannot have accepted a packet that is too long for a demo record.
  if (messages.empty() || messages.size() > formats::kMaxStockDemMessage || is_full()) return;
  writer_.add(view_angles_deg, messages);
  bytes_ += messages.size();
}

base::ByteVector DemoWriter::finish() && {
  base::ByteWriter end;
  const base::Status written = write_message(Disconnect{}, Dialect{}, end);
  CHECK(written.ok());
  writer_.add(math::Vec3{0.0f}, end.view());
  return std::move(writer_).take();
}

}  // namespace temblor::net
