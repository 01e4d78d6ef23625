#include "host/played_host.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "client_server/served_game.h"
#include "support/models/drawable_models.h"
#include "support/programs/quakec.h"

namespace temblor::test {
namespace {

base::Status write_file(const std::filesystem::path& file, base::Bytes bytes) {
  std::ofstream stream(file, std::ios::binary);
  stream.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  return stream ? base::Status(base::Ok{})
                : base::Status(base::error(base::ErrorCode::kIo, "{} cannot be written", file.string()));
}

}  // namespace

PlayedHost::PlayedHost(std::vector<std::string> commands, platform::PixelSize size)
    : window_({.size = size}) {
  game_.folder().write("id1/progs/player.mdl", formats::write_mdl(box_mdl()));
  game_.folder().write("id1/progs.dat", compile_quakec(small_program()));
  always_ = {"host_maxfps 10000", "r_threads 1",
             fmt::format("vid_width {}; vid_height {}", size.width, size.height)};
  commands.insert(commands.begin(), always_.begin(), always_.end());
  start(std::move(commands));
}

void PlayedHost::start(std::vector<std::string> commands,
                       const std::function<base::Status(command::Variables&)>& command_line) {
  host_.reset();
  window_.set_now(now_s_);
  variables_ = std::make_unique<command::Variables>();
  host_variables_ = std::make_unique<host::HostVariables>(*variables_);
  host::Services services{.window = window_,
                          .write_file = write_file,
                          .print_line = [this](std::string_view line) { lines_.emplace_back(line); }};
  host::HostOptions options{.folders = {game_.path(), {}}, .commands = std::move(commands)};
  // The program does it before as well, to open its window.
  if (command_line) CHECK(command_line(*variables_).ok());
  if (command_line)
    options.apply_overrides = [command_line, variables = variables_.get()] {
      return command_line(*variables);
    };
  auto started = host::Host::start(std::move(services), *host_variables_, std::move(options));
  CHECK(started.ok(), "{}", started.error().message());
  host_ = std::move(*started);
}

void PlayedHost::start_again(std::function<base::Status(command::Variables&)> command_line) {
  lines_.clear();
  start(always_, command_line);
}

void PlayedHost::run(double seconds, double frame_s) {
  const double until_s = now_s_ + seconds;
  while (now_s_ < until_s) {
    now_s_ += frame_s;
    window_.set_now(now_s_);
    if (!host_->frame()) return;
  }
}

bool PlayedHost::run_until_playing() {
  for (int i = 0; i < 720 && !host_->session().is_playing(); ++i) run(1.0 / 72);
  return host_->session().is_playing();
}

bool PlayedHost::has_printed(std::string_view part) const {
  return std::any_of(lines_.begin(), lines_.end(),
                     [&](const std::string& line) { return line.find(part) != std::string::npos; });
}

}  // namespace temblor::test
