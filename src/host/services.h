// What the host needs from the outside world; the program gives it the real things, tests others.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string_view>

#include "base/bytes.h"
#include "base/result.h"
#include "net/transport/server_endpoint.h"
#include "platform/address.h"
#include "platform/audio_device.h"
#include "platform/datagram_socket.h"
#include "platform/window.h"

namespace temblor::host {

inline constexpr std::uint16_t kStockPort = 26000;  // UDP; where servers listen unless told

struct Services {
  platform::Window& window;
  // A UDP socket; 0: any port that is free. Null: there is no network.
  std::function<base::Result<std::unique_ptr<platform::DatagramSocket>>(std::uint16_t port)> open_socket{};
  // "HOST" or "HOST:PORT" to an address; null where there is no network.
  std::function<base::Result<platform::Address>(std::string_view host, std::uint16_t default_port)> look_up{};
  // Null: silence.
  std::function<base::Result<std::unique_ptr<platform::AudioDevice>>(platform::AudioFill fill)> open_audio{};
  // Replaces a file whole, or leaves the old one.
  std::function<base::Status(const std::filesystem::path& file, base::Bytes bytes)> write_file;
  // A line for the terminal.
  std::function<void(std::string_view line)> print_line;
  std::uint64_t seed = 1;  // of the games' dice
  net::Secret secret{};
};

}  // namespace temblor::host
