#include "app/commands/serve_command.h"

#include <fmt/format.h>

#include <cstdio>

#include "app/bench/system.h"
#include "app/commands/command_line.h"
#include "app/files/atomic_write.h"
#include "app/files/diagnostics.h"
#include "app/files/file_watch.h"
#include "app/files/game_files.h"
#include "app/files/interrupt.h"
#include "app/files/line_input.h"
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
    R"(Type `help` for the console's commands, `quit` to end.

Examples:
  temblor --basedir quake serve --map e1m1
  temblor --basedir quake serve --map dm3 --maxclients 16 --set deathmatch=1
  temblor --basedir quake serve --map start --progs mymod/progs.dat)";

constexpr const char* kConfiguration = "server.cfg";
constexpr double kLookAtFilesEvery_s = 0.5;
constexpr std::uint64_t kMaxConfigurationBytes = 1 << 20;

net::ServerEndpointSettings wire_settings() {
  net::ServerEndpointSettings settings;
  settings.secret = any_secret();
  return settings;
}

// QuakeC's letters with the upper bit set are the same ones in another color.
void print_text(std::string_view text) {
  for (char c : text) {
    c = static_cast<char>(c & 127);
    if (c >= ' ' || c == '\n' || c == '\t') std::fputc(c, stdout);
  }
  std::fflush(stdout);
}

// The program's and the level's files, so that a change of either is taken up.
class GameFileWatch {
 public:
  explicit GameFileWatch(std::string program) : program_(std::move(program)) {}

  bool has_changed(server::Server& io_server, double now_s) {
    if (now_s - looked_at_s_ < kLookAtFilesEvery_s || !io_server.game()) return false;
    looked_at_s_ = now_s;
    const std::string& map = io_server.game()->setup().map_name;
    if (map != map_) {
      map_ = map;
      watch_ = FileWatch();
      const vfs::FileSystem& files = io_server.files();
      watch_.add({stamp_of(program_.empty() ? files.where("progs.dat") : program_),
                  stamp_of(files.where(fmt::format("maps/{}.bsp", map)))});
    }
    return watch_.has_changed();
  }

 private:
  std::string program_, map_;
  FileWatch watch_;
  double looked_at_s_ = 0;
};

std::string is_port(const std::string& text) {
  const std::optional<std::int64_t> number = command::parse_whole_number(text);
  if (number && *number >= 0 && *number <= 65535) return {};
  return fmt::format("\"{}\" is no UDP port: those are 1 to 65535; 0 takes any that is free",
                     base::quotable(text));
}

base::Result<std::unique_ptr<platform::DatagramSocket>> open_socket(const ServeOptions& options) {
  auto socket = platform::posix::open_udp_socket({.port = options.port, .host = options.host});
  if (socket.ok() || options.port == 0 || socket.error().code != base::ErrorCode::kIo) return socket;
  base::Error error = socket.error();
  error.what += "; --port N takes another one, --port 0 any that is free";
  return error;
}

base::Result<std::string> read_configuration(const vfs::FileSystem& files, std::string_view name) {
  base::Result<base::ByteVector> bytes = files.read(name);
  if (!bytes.ok()) bytes = vfs::read_disk_file(std::string(name), kMaxConfigurationBytes);
  if (!bytes.ok()) return bytes.error();
  return std::string(base::as_text(*bytes));
}

void serve(server::Server& io_server, const ServeOptions& options) {
  Interrupt interrupt;
  interrupt.hold();
  LineInput input;
  GameFileWatch watch(options.program);
  const double began_s = clock_s();
  while (!io_server.wants_to_quit() && !interrupt.was_noted()) {
    for (const std::string& line : input.wait(io_server.until_next_tick_s(clock_s())))
      io_server.console().append(line);
    const double now_s = clock_s();
    if (options.duration_s > 0 && now_s - began_s >= options.duration_s) break;
    io_server.step(now_s);
    if (io_server.settings().reloads() && watch.has_changed(io_server, now_s))
      io_server.console().append("reload");
  }
  io_server.shut_down("The server has ended.");
}

}  // namespace

Command* add_serve_command(Command& program, ServeOptions& io_options) {
  Command* command = program.add_subcommand("serve", "A dedicated server, its console on standard input");
  command->add_option("--map", io_options.map, "Level to begin with")->type_name("NAME")->required();
  command->add_option("--port", io_options.port, "UDP port, 0 to 65535; 0: any that is free")
      ->type_name("N")
      ->check(is_port)
      ->capture_default_str();
  command->add_option("--host", io_options.host, "Receives on this address of the machine alone")
      ->type_name("ADDRESS");
  command
      ->add_option("--maxclients", io_options.max_clients,
                   "Players at a time; stock clients refuse servers of more than 16")
      ->type_name("N")
      ->check(in_range(1, 255))
      ->capture_default_str();
  command
      ->add_option("--progs", io_options.program, "The game's code; without it the game folders' progs.dat")
      ->type_name("FILE");
  command
      ->add_option("--exec", io_options.execute, "Console commands before the level begins; may be repeated")
      ->type_name("COMMANDS")
      ->allow_extra_args(false)
      ->take_all();
  command->add_option("--duration", io_options.duration_s, "Ends by itself after so many seconds")
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
       .wire = wire_settings(),
       .max_clients = options.max_clients,
       .program_file = options.program,
       .write_folder = library.files().folders().back(),
       .write_file = [](const std::filesystem::path& file,
                        base::Bytes bytes) { return replace_file(file, bytes, Remedy::kNone); },
       .print = print_text,
       .seed = any_seed()});
  server.console().set_loader(
      [&](std::string_view name) { return read_configuration(library.files(), name); });
  if (library.files().contains(kConfiguration)) {
    server.console().append(fmt::format("exec {}", kConfiguration));
    server.console().run();
    TRY_STATUS(apply_options(common, std::nullopt, settings.variables()));
  }
  for (const std::string& line : options.execute) server.console().append(line);
  server.console().run();
  TRY_STATUS(server.start_map(options.map));
  print_text(fmt::format("{}: UDP port {}, {} at most, level {}, protocol {}\n", settings.host_name(), port,
                         base::counted(options.max_clients, "player"), options.map,
                         static_cast<int>(server.game()->setup().dialect.protocol)));
  serve(server, options);
  return base::Ok{};
}

}  // namespace temblor::app
