#include "net/protocol/demo_writer.h"

#include "base/check.h"
#include "net/protocol/message_writer.h"

namespace temblor::net {

void DemoRecording::add(const math::Vec3& view_angles_deg, base::Bytes messages) {
  // What is too long for one record was too long for the client as well.
  if (messages.empty() || messages.size() > formats::kMaxDemMessage || is_full()) return;
  writer_.add(view_angles_deg, messages);
  bytes_ += messages.size();
}

base::ByteVector DemoRecording::finish() && {
  base::ByteWriter end;
  const base::Status written = write_message(Disconnect{}, Dialect{}, end);
  CHECK(written.ok());
  writer_.add(math::Vec3{0.0f}, end.view());
  return std::move(writer_).take();
}

}  // namespace temblor::net
