// A recording (.dem) of what one player is told.
#pragma once

#include <filesystem>
#include <span>

#include "base/result.h"
#include "formats/dem.h"
#include "server/client.h"
#include "server/game.h"

namespace temblor::server {

class Recorder {
 public:
  // Begins with all that a client is told who joins now.
  static base::Result<Recorder> begin(Game& io_game, std::span<const Client> clients, std::size_t slot,
                                      std::filesystem::path file);

  std::size_t slot() const { return slot_; }
  // It is held in memory until it is finished; what comes when it is full is left out.
  static constexpr std::size_t kMaxBytes = std::size_t{256} << 20;
  bool is_full() const { return bytes_ >= kMaxBytes; }
  const std::filesystem::path& file() const { return file_; }
  // What this player is told in one tick.
  void add(const math::Vec3& view_angles_deg, base::Bytes messages);
  // The recording's bytes, with its end.
  base::ByteVector finish() &&;

 private:
  Recorder(std::size_t slot, std::filesystem::path file) : slot_(slot), file_(std::move(file)) {}
  std::size_t slot_;
  std::size_t bytes_ = 0;
  std::filesystem::path file_;
  formats::DemWriter writer_;
};

}  // namespace temblor::server
