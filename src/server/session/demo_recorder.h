// Records a demo (.dem) of what one player sees and hears: the signon as a client that joins now would get
// it, then the player's messages of each tick. The file format is net/protocol/demo_writer.h.
#pragma once

#include <filesystem>
#include <span>

#include "base/result.h"
#include "net/protocol/demo_writer.h"
#include "server/game.h"
#include "server/session/client.h"

namespace temblor::server {

class DemoRecorder {
 public:
  // Starts with everything that a client is sent when it joins. `file` is only stored for the caller.
  static base::Result<DemoRecorder> begin(Game& io_game, std::span<const Client> clients, std::size_t slot,
                                          std::filesystem::path file);

  std::size_t slot() const { return slot_; }
  // Whether the demo has reached its maximum size; later messages are not recorded.
  bool is_full() const { return recording_.is_full(); }
  const std::filesystem::path& file() const { return file_; }
  // Adds what the player is sent in one tick.
  void add(const math::Vec3& view_angles_deg, base::Bytes messages) {
    recording_.add(view_angles_deg, messages);
  }
  // The whole demo, including its end.
  base::ByteVector finish() && { return std::move(recording_).finish(); }

 private:
  DemoRecorder(std::size_t slot, std::filesystem::path file) : slot_(slot), file_(std::move(file)) {}
  std::size_t slot_;
  std::filesystem::path file_;
  net::DemoWriter recording_;
};

}  // namespace temblor::server
