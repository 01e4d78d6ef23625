// The services that the host needs from the operating system: window, network, sound, files, terminal.
//
// The program passes in the real ones. Tests pass in fakes: a window without a display, a loopback network,
// and a clock that they advance themselves. The host reads time only from the window (Window::now_s()).
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
#include "platform/gl_context.h"
#include "platform/window.h"

namespace temblor::host {

inline constexpr std::uint16_t kDefaultPort = 26000;  // UDP; the stock game's

// All functions are called on the thread of the host's frames, except for write_file: a server tick that runs
// on the worker thread may save a game.
struct Services {
  platform::Window& window;
  // Opens a UDP socket; port 0: any free one. Null: there is no network.
  std::function<base::Result<std::unique_ptr<platform::DatagramSocket>>(std::uint16_t port)> open_socket{};
  // Resolves "HOST" or "HOST:PORT". Null: there is no network.
  std::function<base::Result<platform::Address>(std::string_view host, std::uint16_t default_port)> look_up{};
  // Whether the address is of this machine. Null: only loopback addresses are.
  std::function<bool(const platform::Address&)> is_own_host{};
  // Null: no sound.
  std::function<base::Result<std::unique_ptr<platform::AudioDevice>>(platform::AudioFill fill)> open_audio{};
  // Makes an OpenGL context without a window, current on the calling thread. Null: there is no OpenGL.
  std::function<base::Result<std::unique_ptr<platform::GlContext>>()> open_gl{};
  // Replaces a file as a whole, or leaves the old one.
  std::function<base::Status(const std::filesystem::path& file, base::Bytes bytes)> write_file;
  // Prints a line, without a newline at its end, to the terminal.
  std::function<void(std::string_view line)> print_line;
  std::uint64_t seed = 1;  // of the game's random numbers
  net::Secret secret{};    // for the server's handshake (net/transport/admission)
};

}  // namespace temblor::host
