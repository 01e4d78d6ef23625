#include "server/session/demo_recorder.h"

#include <fmt/format.h>

#include "server/server.h"
#include "server/session/signon.h"
#include "server/session/stages.h"

namespace temblor::server {

base::Result<DemoRecorder> DemoRecorder::begin(Game& io_game, std::span<const Client> clients,
                                               std::size_t slot, std::filesystem::path file) {
  DemoRecorder recorder(slot, std::move(file));
  const math::Vec3 angles = io_game.player(slot)[field::kViewAngles];
  TRY(const base::ByteVector level, make_level_message(io_game, slot));
  recorder.recording_.add(angles, level);
  TRY(const std::vector<base::ByteVector> signon, make_signon_messages(io_game));
  for (const base::ByteVector& part : signon) recorder.recording_.add(angles, part);
  TRY(const std::vector<base::ByteVector> state, make_state_messages(io_game, clients, slot));
  for (const base::ByteVector& part : state) recorder.recording_.add(angles, part);
  return recorder;
}

// The recorder needs a client, because it records what that client's queue gets.
base::Status record_demo(Server& io_server, std::size_t slot, std::string_view name) {
  Clients& clients = io_server.clients;
  if (!io_server.game || slot >= clients.size() || !clients[slot].is_in_game() || clients[slot].is_bot())
    return base::error(base::ErrorCode::kUsage, "there is no player {} to record; `status` lists them",
                       static_cast<std::int64_t>(slot) + 1);
  if (io_server.recorder)
    return base::error(base::ErrorCode::kUsage, "a demo is being recorded already; `stop` ends it");
  TRY(std::filesystem::path file, make_write_path(io_server, name, ".dem"));
  TRY(io_server.recorder, DemoRecorder::begin(*io_server.game, clients.all(), slot, std::move(file)));
  clients.record_slot(slot);
  print(io_server, fmt::format("Recording demo of {} to {}. Type stop to finish.\n", clients[slot].name,
                               io_server.recorder->file().string()));
  return base::Ok{};
}

base::Status stop_demo(Server& io_server) {
  std::optional<DemoRecorder>& recorder = io_server.recorder;
  if (!recorder) return base::error(base::ErrorCode::kUsage, "no demo is being recorded");
  const std::filesystem::path file = recorder->file();
  if (recorder->is_full()) print(io_server, "the demo reached its maximum size: its end is missing\n");
  const base::ByteVector bytes = std::move(*recorder).finish();
  recorder.reset();
  io_server.clients.record_slot(std::nullopt);
  TRY_STATUS(io_server.setup.write_file(file, bytes));
  print(io_server, fmt::format("Demo saved: {}\n", file.string()));
  return base::Ok{};
}

}  // namespace temblor::server
