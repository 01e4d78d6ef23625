// A host in a window without a display, on a clock that the test turns, with the level made in code or with
// real data.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "command/variables.h"
#include "host/host.h"
#include "host/host_variables.h"
#include "platform/headless/window.h"
#include "support/programs/small_game.h"

namespace temblor::test {

class PlayedHost {
 public:
  // The level "small" and a small program; the compiler of QuakeC has to be here. `commands` are run first.
  explicit PlayedHost(std::vector<std::string> commands = {}, platform::PixelSize size = {320, 200});
  // The same game folder once more, as when the program is started again; `command_line` is
  // HostOptions::apply_overrides.
  void start_again(std::function<base::Status(command::Variables&)> command_line = nullptr);

  // Frames at even distances.
  void run(double seconds, double frame_s = 1.0 / 72);
  // Runs until the player is in a game, ten seconds at most. False: he is not.
  bool run_until_playing();
  void command(std::string_view line) { host().console().append(line); }
  void press(platform::Key key) { window_.put(platform::KeyChange{key, true}); }
  void release(platform::Key key) { window_.put(platform::KeyChange{key, false}); }

  host::Host& host() { return *host_; }
  platform::headless::HeadlessWindow& window() { return window_; }
  const host::HostVariables& variables() const { return *host_variables_; }
  const std::vector<std::string>& lines() const { return lines_; }
  bool has_printed(std::string_view part) const;
  const TemporaryFolder& folder() const { return game_.folder(); }
  const client::Game& game() { return host().session().connection()->state().game(); }
  double now_s() const { return now_s_; }

 private:
  void start(std::vector<std::string> commands,
             const std::function<base::Status(command::Variables&)>& command_line = nullptr);

  SmallGame game_;
  std::vector<std::string> always_;  // commands of every start
  platform::headless::HeadlessWindow window_;
  std::unique_ptr<command::Variables> variables_;
  std::unique_ptr<host::HostVariables> host_variables_;
  std::unique_ptr<host::Host> host_;
  std::vector<std::string> lines_;
  double now_s_ = 100;
};

}  // namespace temblor::test
