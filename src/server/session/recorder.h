// A recording (.dem) of what one player is told.
#pragma once

#include <filesystem>
#include <span>

#include "base/result.h"
#include "net/protocol/demo_writer.h"
#include "server/game.h"
#include "server/session/client.h"

namespace temblor::server {

class Recorder {
 public:
  // Begins with all that a client is told who joins now.
  static base::Result<Recorder> begin(Game& io_game, std::span<const Client> clients, std::size_t slot,
                                      std::filesystem::path file);

  std::size_t slot() const { return slot_; }
  bool is_full() const { return recording_.is_full(); }
  const std::filesystem::path& file() const { return file_; }
  // What this player is told in one tick.
  void add(const math::Vec3& view_angles_deg, base::Bytes messages) {
    recording_.add(view_angles_deg, messages);
  }
  // The recording's bytes, with its end.
  base::ByteVector finish() && { return std::move(recording_).finish(); }

 private:
  Recorder(std::size_t slot, std::filesystem::path file) : slot_(slot), file_(std::move(file)) {}
  std::size_t slot_;
  std::filesystem::path file_;
  net::DemoRecording recording_;
};

}  // namespace temblor::server
