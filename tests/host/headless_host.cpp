#include "host/headless_host.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "client_server/served_game.h"
#include "host/frame/host_parts.h"
#include "support/models/drawable_models.h"
#include "support/programs/quakec.h"

namespace temblor::test {
namespace {

base::Status write_file(const std::filesystem::path& file, base::Bytes bytes) {
  std::ofstream stream(file, std::ios::binary);
  stream.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  return stream ? base::Status(base::Ok{})
                : base::Status(base::error(base::ErrorCode::kIo, "cannot write {}", file.string()));
}

}  // namespace

HeadlessHost::HeadlessHost(std::vector<std::string> commands, platform::PixelSize size)
    : window_({.size = size}) {
  game_.folder().write("id1/progs/player.mdl", formats::write_mdl(box_mdl()));
  game_.folder().write("id1/progs.dat", compile_quakec(small_program()));
  start_commands_ = {"host_maxfps 10000", "r_threads 1",
                     fmt::format("vid_width {}; vid_height {}", size.width, size.height)};
  commands.insert(commands.begin(), start_commands_.begin(), start_commands_.end());
  start(std::move(commands));
}

void HeadlessHost::start(std::vector<std::string> commands,
                         const std::function<base::Status(command::Variables&)>& command_line) {
  host_.reset();
  window_.set_now(now_s_);
  variables_ = std::make_unique<command::Variables>();
  host_variables_ = std::make_unique<host::HostVariables>(*variables_);
  const auto open_gl = [this]() -> base::Result<std::unique_ptr<platform::GlContext>> {
    if (!open_gl_) return base::error(base::ErrorCode::kUnsupported, "OpenGL is missing");
    return open_gl_();
  };
  host::Services services{.window = window_,
                          .open_gl = open_gl,
                          .write_file = write_file,
                          .print_line = [this](std::string_view line) { lines_.emplace_back(line); }};
  host::HostOptions options{.folders = {game_.path(), {}}, .commands = std::move(commands)};
  // The program applies them before the start, too, to open its window.
  if (command_line) CHECK(command_line(*variables_).ok());
  if (command_line)
    options.apply_overrides = [command_line, variables = variables_.get()] {
      return command_line(*variables);
    };
  auto started = host::start_host(std::move(services), *host_variables_, std::move(options));
  CHECK(started.ok(), "{}", started.error().message());
  host_ = std::move(*started);
}

void HeadlessHost::restart(std::function<base::Status(command::Variables&)> command_line,
                           std::vector<std::string> commands) {
  lines_.clear();
  commands.insert(commands.begin(), start_commands_.begin(), start_commands_.end());
  start(std::move(commands), command_line);
}

void HeadlessHost::run(double seconds, double frame_s) {
  const double until_s = now_s_ + seconds;
  while (now_s_ < until_s) {
    now_s_ += frame_s;
    window_.set_now(now_s_);
    if (!host::run_frame(*host_)) return;
  }
}

bool HeadlessHost::run_until_playing() {
  for (int i = 0; i < 720 && !session().is_playing(); ++i) run(1.0 / 72);
  return session().is_playing();
}

host::Session& HeadlessHost::session() {
  return *host_->game.session;
}

client::DemoSession* HeadlessHost::demo() {
  std::optional<client::DemoSession>& session = host_->demos.session;
  return session ? &*session : nullptr;
}

bool HeadlessHost::has_printed(std::string_view part) const {
  return std::any_of(lines_.begin(), lines_.end(),
                     [&](const std::string& line) { return line.find(part) != std::string::npos; });
}

}  // namespace temblor::test
