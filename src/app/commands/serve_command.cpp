#include "app/commands/serve_command.h"

#include <fmt/format.h>

#include <cstdio>

#include "app/commands/command_line.h"
#include "app/files/atomic_write.h"
#include "app/files/diagnostics.h"
#include "app/files/file_watch.h"
#include "app/files/game_files.h"
#include "app/files/interrupt.h"
#include "app/files/line_input.h"
#include "app/files/system.h"
#include "assets/library.h"
#include "base/text.h"
#include "command/text.h"
#include "net/transport/server_endpoint.h"
#include "platform/posix/udp_socket.h"
#include "server/server.h"
#include "vfs/disk.h"

namespace temblor::app {
namespace {

constexpr const char* kServeHelpFooter =
    R"(Standard input is the server's console: `help` lists its commands, `quit` stops the server. If a game
directory contains server.cfg, its commands run first. docs/hosting.md describes the settings of a server.

Examples:
  temblor serve --map start
  temblor --basedir ~/quake serve --map e1m1
  temblor --basedir ~/quake serve --map dm3 --maxclients 16 --set deathmatch=1
  temblor --basedir ~/quake serve --map start --progs mymod/progs.dat)";

constexpr const char* kConfiguration = "server.cfg";
constexpr double kLookAtFilesEvery_s = 0.5;
constexpr std::uint64_t kMaxConfigurationBytes = 1 << 20;

// Returns the default network settings with a new secret, which handshakes use to verify addresses.
net::ServerEndpointSettings make_wire_settings() {
  net::ServerEndpointSettings settings;
  settings.secret = make_secret();
  return settings;
}

// Prints console text without control characters. Characters with the high bit set are the same letters in
// bronze.
void print_text(std::string_view text) {
  for (char c : text) {
    c = static_cast<char>(c & 127);
    if (c >= ' ' || c == '\n' || c == '\t') std::fputc(c, stdout);
  }
  std::fflush(stdout);
}

// Watches progs.dat and the current level's .bsp, so that the server can reload when either is saved
// (sv_reload).
class GameFileWatch {
 public:
  explicit GameFileWatch(std::string program) : program_(std::move(program)) {}

  // Checks at most every kLookAtFilesEvery_s. When the level changes, watches the files of the new one.
  bool has_changed(server::Server& io_server, double now_s) {
    if (now_s - looked_at_s_ < kLookAtFilesEvery_s || !io_server.game) return false;
    looked_at_s_ = now_s;
    const std::string& map = io_server.game->setup().map_name;
    if (map != map_) {
      map_ = map;
      watch_ = FileWatch();
      const vfs::FileSystem& files = io_server.setup.library.files();
      watch_.add({read_file_stamp(program_.empty() ? files.where("progs.dat") : program_),
                  read_file_stamp(files.where(fmt::format("maps/{}.bsp", map)))});
    }
    return watch_.has_changed();
  }

 private:
  std::string program_, map_;
  FileWatch watch_;
  double looked_at_s_ = 0;
};

// Returns an error message unless the text is a port.
std::string check_port(const std::string& text) {
  const std::optional<std::int64_t> number = command::parse_whole_number(text);
  if (number && *number >= 0 && *number <= 65535) return {};
  return fmt::format("\"{}\" is not a UDP port; choose 1 to 65535, or 0 for any free port",
                     base::quotable(text));
}

// Opens the server's socket. The error for a port that is in use suggests another one.
base::Result<std::unique_ptr<platform::DatagramSocket>> open_socket(const ServeOptions& options) {
  auto socket = platform::posix::open_udp_socket({.port = options.port, .host = options.host});
  if (socket.ok() || options.port == 0 || socket.error().code != base::ErrorCode::kIo) return socket;
  base::Error error = socket.error();
  error.what += "; choose another port with --port N, or any free one with --port 0";
  return error;
}

// Reads a file for the console command `exec`: from the game directories, otherwise from disk.
base::Result<std::string> read_configuration(const vfs::FileSystem& files, std::string_view name) {
  base::Result<base::ByteVector> bytes = files.read(name);
  if (!bytes.ok()) bytes = vfs::read_disk_file(std::string(name), kMaxConfigurationBytes);
  if (!bytes.ok()) return bytes.error();
  return std::string(base::as_text(*bytes));
}

// The server's loop: waits for input until the next tick is due, then runs console commands and the tick.
void serve(server::Server& io_server, const ServeOptions& options) {
  Interrupt interrupt;
  interrupt.defer();
  LineInput input;
  GameFileWatch watch(options.program);
  const double began_s = clock_s();
  while (!io_server.wants_to_quit && !interrupt.was_requested()) {
    for (const std::string& line : input.wait(server::time_until_next_tick_s(io_server, clock_s())))
      io_server.console.append(line);
    const double now_s = clock_s();
    if (options.duration_s > 0 && now_s - began_s >= options.duration_s) break;
    server::step_server(io_server, now_s);
    if (io_server.settings().reloads() && watch.has_changed(io_server, now_s))
      io_server.console.append("reload");
  }
  server::shut_down(io_server, "The server has shut down.");
}

}  // namespace

Command* add_serve_command(Command& program, ServeOptions& io_options) {
  Command* command = program.add_subcommand("serve", "Run a dedicated server; its console is standard input");
  command->add_option("--map", io_options.map, "First level")->type_name("NAME")->required();
  command->add_option("--port", io_options.port, "UDP port; 0: any free port")
      ->type_name("N")
      ->check(check_port)
      ->capture_default_str();
  command->add_option("--host", io_options.host, "Listen only on this address")->type_name("ADDRESS");
  command
      ->add_option(
          "--maxclients", io_options.max_clients,
          "Maximum number of players, up to 255 (default: --set maxplayers=N, maxplayers of server.cfg, "
          "or 8); stock clients refuse more than 16")
      ->type_name("N")
      ->check(in_range(1, 255));
  command->add_option("--progs", io_options.program, "Game code (default: progs.dat of the game directories)")
      ->type_name("FILE");
  command->add_option("--exec", io_options.execute, "Run console commands before the first level; repeatable")
      ->type_name("COMMANDS")
      ->allow_extra_args(false)
      ->take_all();
  command->add_option("--duration", io_options.duration_s, "Quit after this time, for scripts")
      ->type_name("SECONDS")
      ->check(not_negative());
  command->footer(kServeHelpFooter);
  return command;
}

base::Status run_serve(const ServeOptions& options, const CommonOptions& common,
                       const server::ServerVariables& settings) {
  TRY(vfs::FileSystem files, open_files(common.folders));
  const assets::Library library(std::move(files));
  net::ServerEndpoint::Sockets sockets(1);
  TRY(sockets[0], open_socket(options));
  const std::uint16_t port = sockets[0]->local_address().port;
  server::Server server(
      {.library = library,
       .settings = settings,
       .sockets = std::move(sockets),
       .wire = make_wire_settings(),
       .program_file = options.program,
       .write_folder = library.files().folders().back(),
       .write_file = [](const std::filesystem::path& file,
                        base::Bytes bytes) { return replace_file(file, bytes, Remedy::kNone); },
       .print = print_text,
       .version = "Temblor " TEMBLOR_VERSION,
       .seed = make_seed()});
  server.console.set_loader([&](std::string_view name) { return read_configuration(library.files(), name); });
  // In order of increasing priority: server.cfg, --set and --maxclients, --exec.
  if (library.files().contains(kConfiguration)) {
    server.console.append(fmt::format("exec {}", kConfiguration));
    server.console.run();
    TRY_STATUS(apply_options(common, std::nullopt, settings.variables()));
  }
  // The variable belongs to the games of a client; on a server, it means the slots.
  constexpr std::string_view kSlots = "maxplayers=";
  for (const std::string_view assignment : common.assignments)
    if (assignment.starts_with(kSlots))
      server.console.execute(fmt::format("maxplayers {}", assignment.substr(kSlots.size())));
  if (options.max_clients > 0) TRY_STATUS(server::set_max_clients(server, options.max_clients));
  for (const std::string& line : options.execute) server.console.append(line);
  server.console.run();
  TRY_STATUS(server::start_map(server, options.map));
  print_text(fmt::format("{}: UDP port {}, up to {}, level {}, protocol {}\n", settings.host_name(), port,
                         base::counted(server.setup.max_clients, "player"), options.map,
                         static_cast<int>(server.game->setup().dialect.protocol)));
  serve(server, options);
  return base::Ok{};
}

}  // namespace temblor::app
