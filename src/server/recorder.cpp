#include "server/recorder.h"

#include "net/message_writer.h"
#include "server/signon.h"

namespace temblor::server {

base::Result<Recorder> Recorder::begin(Game& io_game, std::span<const Client> clients, std::size_t slot,
                                       std::filesystem::path file) {
  Recorder recorder(slot, std::move(file));
  const math::Vec3 angles = io_game.player(slot)[field::kViewAngles];
  TRY(const base::ByteVector level, level_message(io_game, slot));
  recorder.add(angles, level);
  TRY(const std::vector<base::ByteVector> beginning, beginning_messages(io_game));
  for (const base::ByteVector& part : beginning) recorder.add(angles, part);
  TRY(const std::vector<base::ByteVector> state, state_messages(io_game, clients, slot));
  for (const base::ByteVector& part : state) recorder.add(angles, part);
  return recorder;
}

void Recorder::add(const math::Vec3& view_angles_deg, base::Bytes messages) {
  // What is too long for one record was too long for the client as well.
  if (messages.empty() || messages.size() > formats::kMaxDemMessage || is_full()) return;
  writer_.add(view_angles_deg, messages);
  bytes_ += messages.size();
}

base::ByteVector Recorder::finish() && {
  base::ByteWriter end;
  const base::Status written = net::write_message(net::Disconnect{}, net::Dialect{}, end);
  CHECK(written.ok());
  add(math::Vec3{0.0f}, end.view());
  return std::move(writer_).take();
}

}  // namespace temblor::server
