// What is played: levels, saved games, other servers, other game folders; and the files of all that.
#include <fmt/format.h>

#include <sstream>

#include "base/text.h"
#include "command/text.h"
#include "formats/images/png.h"
#include "host/commands/configuration.h"
#include "host/host.h"

namespace temblor::host {
namespace {

constexpr int kMaxScreenshots = 10000;

}  // namespace

// What depends on the game folders is made anew.
void Host::take_up_data() {
  session_ = std::make_unique<Session>(services_, data_->library, data_->write_folder, variables_.server(),
                                       options_.program_file);
  menu_lists_ = std::make_unique<MenuLists>(*this, *data_);
  menu_.emplace(variables_.variables(), data_->presentation.pictures(), menu_lists_->content());
}

base::Status Host::configure() {
  // Nothing of what the folders before have set; nor of the command line, which is to come last.
  overrides_.release_changed(variables_.variables());
  variables_.reset();
  console_.set_loader([this](std::string_view name) -> base::Result<std::string> {
    if (name != kConfigurationFile) return read_commands(*data_, name);
    TRY(ReadConfiguration configuration, read_configuration(*data_));
    return std::move(configuration.text);
  });
  const auto run = [this](std::string_view file) {
    console_.append(command::join_words({"exec", std::string(file)}));
    console_.run();
  };
  bindings_.unbind_all();
  // A game's own defaults first, for what it binds besides; the keys that hands know win over the original's.
  if (data_->library.files().contains("default.cfg")) run("default.cfg");
  bindings_.add_defaults();
  if (const std::optional<std::string> file = configuration_to_run(*data_)) {
    const std::size_t errors = console_.errors_in_files();
    run(*file);
    if (*file == kConfigurationFile) check_configuration(console_.errors_in_files() - errors);
  }
  if (has_commands(*data_, "autoexec.cfg")) run("autoexec.cfg");
  if (options_.apply_overrides)
    TRY_STATUS(overrides_.apply(options_.apply_overrides, variables_.variables()));
  console_ui_.load_history(read_history(*data_));
  window_settings_ = variables_.window();
  // What this display cannot show is no reason not to play.
  if (const base::Status applied = services_.window.apply(window_settings_); !applied.ok())
    print(applied.error().message());
  for (const std::string& line : options_.commands) console_.append(line);
  has_begun_ = false;
  return base::Ok{};
}

// Settings that could not be read are the player's: he is told, and keeps them.
void Host::check_configuration(std::size_t wrong_lines) {
  const base::Result<ReadConfiguration> read = read_configuration(*data_);
  const std::size_t lost = wrong_lines + (read.ok() ? read->unreadable_lines : 1);
  if (lost == 0) return;
  const auto kept = keep_configuration_aside(*data_);
  std::string text =
      fmt::format("In {} {} could not be read. All the others hold; what those said is as it was at first.",
                  kConfigurationFile, base::counted(lost, "line"));
  if (!kept.ok())
    text += fmt::format("\n\nThe file cannot be kept: {}", kept.error().message());
  else if (*kept)
    text += fmt::format("\n\nThe file as it was is kept as\n{}", (*kept)->string());
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (!line.empty()) print(line);
  notices_.push_back({"Damaged settings", text, {{"Options", client::MenuPage::kOptions}}});
}

base::Status Host::open_own_server(std::uint32_t max_clients) {
  return session_->open_server(max_clients, variables_.port(), variables_.player());
}

// A name that is mistyped must not end what is being played.
base::Status Host::start_map(std::string_view map) {
  const std::string file = fmt::format("maps/{}.bsp", map);
  if (!data_->library.files().contains(file))
    return base::error(base::ErrorCode::kNotFound, "there is no level \"{}\"; `maps` lists them", map);
  TRY_STATUS(stop_recording_if_any());
  stop_demo();
  TRY_STATUS(open_own_server(variables_.max_players()));
  return take_up(session_->server()->start_map(map));
}

base::Status Host::load_game(std::string_view name) {
  std::string file(name);
  if (!file.ends_with(".sav")) file += ".sav";
  std::error_code ignored;
  if (!std::filesystem::exists(data_->write_folder / file, ignored))
    return base::error(base::ErrorCode::kNotFound, "there is no saved game \"{}\"", name);
  TRY_STATUS(stop_recording_if_any());
  stop_demo();
  TRY_STATUS(open_own_server(1));
  return take_up(session_->server()->load(name));
}

// A server without a level is of no use; one that had one goes on.
base::Status Host::take_up(base::Status started) {
  if (started.ok()) {
    console_ui_.close();
    menu_->close();
    saved_s_ = now_s_;
  } else if (session_->server()->game() == nullptr) {
    session_->disconnect("");
  }
  return started;
}

base::Status Host::save_game(std::string_view name) {
  if (session_->server() == nullptr) return base::error(base::ErrorCode::kUsage, "save: no game runs here");
  TRY_STATUS(session_->server()->save(name));
  saved_s_ = now_s_;
  // What is shown now may have the menu on it that asked for this.
  std::string stem(name);
  if (stem.ends_with(".sav")) stem.resize(stem.size() - 4);
  picture_wanted_ = stem;
  return base::Ok{};
}

// Of the view alone, beside the saved game.
void Host::keep_picture(const render::FrameBuffer& frame) {
  const std::string name = std::exchange(picture_wanted_, {});
  std::vector<std::uint32_t> rgb(frame.rgb().begin(), frame.rgb().end());
  for (const std::uint8_t index : frame.indexed()) rgb.push_back(render::to_rgb(data_->look.palette[index]));
  Thumbnails& thumbnails = menu_lists_->thumbnails();
  const formats::Picture picture = make_thumbnail(rgb, frame.width(), frame.height(), thumbnails.colors());
  const base::Result<base::ByteVector> png =
      formats::write_png(picture.pixels, kThumbnailWidth, kThumbnailHeight, data_->look.palette);
  const base::Status written =
      png.ok() ? services_.write_file(thumbnails.file_of_save(name), *png) : base::Status(png.error());
  if (!written.ok()) print(written.error().message());
  thumbnails.forget_save(name);
}

bool Host::can_save() {
  if (!session_->is_alone() || !session_->is_playing()) return false;
  const client::Game& game = session_->connection()->state().game();
  return game.stat(client::Stat::kHealth) > 0 && game.ending == client::Ending::kNone;
}

std::string Host::unsaved() {
  constexpr double kWorthAsking_s = 5;
  if (!can_save() || now_s_ - saved_s_ < kWorthAsking_s) return {};
  if (session_->server()->saves_when_left()) return {};
  return "What was played since the last save is lost.";
}

void Host::search_servers() {
  if (const base::Status begun = search_.begin(now_s_); !begun.ok()) print(begun.error().message());
}

void Host::open_menu(client::MenuPage page) {
  console_ui_.close();
  console_.append(held_.release_all());
  menu_->open(page);
}

void Host::toggle_menu() {
  if (menu_->is_open())
    menu_->close();
  else
    open_menu(client::MenuPage::kMain);
}

base::Status Host::connect(std::string_view address) {
  TRY_STATUS(stop_recording_if_any());
  stop_demo();
  TRY_STATUS(session_->connect(address, variables_.player()));
  console_ui_.close();
  menu_->close();
  print(fmt::format("connecting to {}", address));
  return base::Ok{};
}

void Host::disconnect() {
  if (const base::Status kept = stop_recording_if_any(); !kept.ok()) print(kept.error().message());
  stop_demo();
  session_->disconnect("The host has left.");
}

// Not in the middle of a command: the configuration is a file of them.
void Host::ask_for_games(std::vector<std::string> games) {
  wanted_games_ = std::move(games);
}

base::Status Host::change_games(std::vector<std::string> games) {
  TRY_STATUS(save_configuration());
  GameFolders folders = options_.folders;
  folders.games = std::move(games);
  TRY(std::unique_ptr<GameData> data, GameData::open(folders));
  disconnect();
  menu_.reset();
  menu_lists_.reset();
  session_.reset();
  data_ = std::move(data);
  options_.folders = std::move(folders);
  options_.commands.clear();
  take_up_data();
  return configure();
}

base::Status Host::save_configuration() {
  const std::string text = configuration_text(bindings_, variables_, overrides_);
  TRY_STATUS(services_.write_file(data_->write_folder / kConfigurationFile, base::as_bytes(text)));
  const std::string history = console_ui_.history_text();
  if (history.empty()) return base::Ok{};
  return services_.write_file(data_->write_folder / kHistoryFile, base::as_bytes(history));
}

base::Status Host::dump_console(std::string_view file) {
  const std::optional<std::string> name = vfs::normalized_name(file);
  if (!name) return base::error(base::ErrorCode::kUsage, "\"{}\" is no name for a file", file);
  const std::filesystem::path path = data_->write_folder / *name;
  TRY_STATUS(services_.write_file(path, base::as_bytes(console_ui_.text())));
  print(fmt::format("wrote {}", path.string()));
  return base::Ok{};
}

base::Status Host::screenshot(std::string_view file) {
  std::filesystem::path path = file;
  std::error_code ignored;
  for (int number = 0; file.empty() && number < kMaxScreenshots; ++number) {
    path = data_->write_folder / fmt::format("temblor{:04}.png", number);
    if (!std::filesystem::exists(path, ignored)) break;
  }
  if (!path.has_extension()) path += ".png";
  if (path.is_relative()) path = data_->write_folder / path;
  const std::span<const std::uint32_t> pixels = screen_.pixels();
  if (pixels.empty()) return base::error(base::ErrorCode::kUsage, "there is no picture yet");
  TRY(const base::ByteVector png,
      formats::write_png(pixels, screen_.frame().width(), screen_.frame().height()));
  TRY_STATUS(services_.write_file(path, png));
  print(fmt::format("wrote {}", path.string()));
  return base::Ok{};
}

}  // namespace temblor::host
