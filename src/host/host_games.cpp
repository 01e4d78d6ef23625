// What is played: levels, saved games, other servers, other game folders; and the files of all that.
#include <fmt/format.h>

#include "formats/png.h"
#include "host/configuration.h"
#include "host/host.h"

namespace temblor::host {
namespace {

constexpr int kMostScreenshots = 10000;

}  // namespace

base::Status Host::open_own_server(std::uint32_t max_clients) {
  return session_->open_server(max_clients, variables_.port(), variables_.player());
}

base::Status Host::start_map(std::string_view map) {
  TRY_STATUS(open_own_server(variables_.max_players()));
  return take_up(session_->server()->start_map(map));
}

base::Status Host::load_game(std::string_view name) {
  TRY_STATUS(open_own_server(1));
  return take_up(session_->server()->load(name));
}

// A server without a level is of no use; one that had one goes on.
base::Status Host::take_up(base::Status started) {
  if (!started.ok() && session_->server()->game() == nullptr) session_->disconnect("");
  return started;
}

base::Status Host::save_game(std::string_view name) {
  if (session_->server() == nullptr) return base::error(base::ErrorCode::kUsage, "save: no game runs here");
  return session_->server()->save(name);
}

base::Status Host::connect(std::string_view address) {
  TRY_STATUS(session_->connect(address, variables_.player()));
  print(fmt::format("connecting to {}", address));
  return base::Ok{};
}

void Host::disconnect() {
  session_->disconnect("The host has left.");
}

base::Status Host::change_games(std::vector<std::string> games) {
  TRY_STATUS(save_configuration());
  GameFolders folders{options_.folders.base_folder, std::move(games)};
  TRY(std::unique_ptr<GameData> data, GameData::open(folders));
  session_.reset();
  data_ = std::move(data);
  options_.folders = std::move(folders);
  session_ = std::make_unique<Session>(services_, data_->library, variables_.server(), options_.program_file);
  return configure();
}

base::Status Host::save_configuration() {
  TRY_STATUS(keep_damaged(data_->library.files(), kConfigurationFile));
  const std::string text = configuration_text(bindings_, variables_);
  return services_.write_file(data_->write_folder() / kConfigurationFile, base::as_bytes(text));
}

base::Status Host::screenshot(std::string_view file) {
  std::filesystem::path path = file;
  std::error_code ignored;
  for (int number = 0; file.empty() && number < kMostScreenshots; ++number) {
    path = data_->write_folder() / fmt::format("temblor{:04}.png", number);
    if (!std::filesystem::exists(path, ignored)) break;
  }
  if (!path.has_extension()) path += ".png";
  if (path.is_relative()) path = data_->write_folder() / path;
  const std::span<const std::uint32_t> pixels = screen_.pixels();
  if (pixels.empty()) return base::error(base::ErrorCode::kUsage, "there is no picture yet");
  TRY(const base::ByteVector png,
      formats::write_png(pixels, screen_.frame().width(), screen_.frame().height()));
  TRY_STATUS(services_.write_file(path, png));
  print(fmt::format("wrote {}", path.string()));
  return base::Ok{};
}

}  // namespace temblor::host
