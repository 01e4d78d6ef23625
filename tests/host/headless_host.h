// A host in a window without a display, for tests. Its clock advances only in run(). It plays a level that is
// generated in code, with a small QuakeC program.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "command/variables.h"
#include "host/host.h"
#include "host/host_variables.h"
#include "host/video/gl_view.h"
#include "platform/headless/window.h"
#include "support/programs/small_game.h"

namespace temblor::client {
class DemoSession;
}
namespace temblor::host {
class Session;
}

namespace temblor::test {

class HeadlessHost {
 public:
  // The game has the level "small". Needs the QuakeC compiler. The first frame runs `commands`.
  explicit HeadlessHost(std::vector<std::string> commands = {}, platform::PixelSize size = {320, 200});
  // Starts the program again with the same game folder. `command_line` is HostOptions::apply_overrides.
  // The first frame runs `commands`.
  void restart(std::function<base::Status(command::Variables&)> command_line = nullptr,
               std::vector<std::string> commands = {});

  // Runs frames at an even rate.
  void run(double seconds, double frame_s = 1.0 / 72);
  // Runs until the player is in a game, for at most ten seconds. Returns whether that succeeded.
  bool run_until_playing();
  void command(std::string_view line) { host::append_commands(host(), line); }
  void press(platform::Key key) { window_.put(platform::KeyChange{key, true}); }
  void release(platform::Key key) { window_.put(platform::KeyChange{key, false}); }

  // The source of contexts for vid_renderer gl, from now on. Without it, there is no OpenGL.
  void set_open_gl(host::OpenGl open_gl) { open_gl_ = std::move(open_gl); }

  host::Host& host() { return *host_; }
  host::Session& session();
  // The current demo; null if no demo is playing.
  client::DemoSession* demo();
  platform::headless::HeadlessWindow& window() { return window_; }
  const host::HostVariables& variables() const { return *host_variables_; }
  const std::vector<std::string>& lines() const { return lines_; }
  bool has_printed(std::string_view part) const;
  const TemporaryFolder& folder() const { return game_.folder(); }

 private:
  void start(std::vector<std::string> commands,
             const std::function<base::Status(command::Variables&)>& command_line = nullptr);

  SmallGame game_;
  std::vector<std::string> start_commands_;  // of every start
  platform::headless::HeadlessWindow window_;
  std::unique_ptr<command::Variables> variables_;
  std::unique_ptr<host::HostVariables> host_variables_;
  host::OpenGl open_gl_;
  host::HostPointer host_;
  std::vector<std::string> lines_;  // printed to the terminal
  double now_s_ = 100;
};

}  // namespace temblor::test
