#include "server/session/recorder.h"

#include "server/session/signon.h"

namespace temblor::server {

base::Result<Recorder> Recorder::begin(Game& io_game, std::span<const Client> clients, std::size_t slot,
                                       std::filesystem::path file) {
  Recorder recorder(slot, std::move(file));
  const math::Vec3 angles = io_game.player(slot)[field::kViewAngles];
  TRY(const base::ByteVector level, level_message(io_game, slot));
  recorder.recording_.add(angles, level);
  TRY(const std::vector<base::ByteVector> beginning, beginning_messages(io_game));
  for (const base::ByteVector& part : beginning) recorder.recording_.add(angles, part);
  TRY(const std::vector<base::ByteVector> state, state_messages(io_game, clients, slot));
  for (const base::ByteVector& part : state) recorder.recording_.add(angles, part);
  return recorder;
}

}  // namespace temblor::server
