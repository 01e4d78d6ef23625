#include "client_server/served_game.h"

#include <chrono>
#include <fstream>
#include <thread>

#include "platform/posix/udp_socket.h"
#include "support/game_data.h"
#include "support/programs/quakec.h"
#include "vfs/disk.h"

namespace temblor::test {
namespace {

constexpr std::string_view kGame = R"(
void() worldspawn = {
  precache_model("progs/player.mdl");
  precache_sound("misc/hello.wav");
  lightstyle(1, "az");
};
void() info_player_start = {};
void() info_intermission = { remove(self); };
void() info_player_deathmatch = {};
void() light = { remove(self); };
void() door_touch = {
  if (other.classname == "player") { sprint(other, "a door\n"); }
};
void() func_door = {
  self.solid = 4; self.movetype = 7;
  setmodel(self, self.model);
  self.touch = door_touch;
};
void() StartFrame = {};
void() PlayerPreThink = {};
void() PlayerPostThink = { if (self.impulse) { bprint(ftos(self.impulse)); bprint("!\n"); self.impulse = 0; } };
void() ClientKill = { self.health = 0; bprint(self.netname); bprint(" is dead\n"); };
void() ClientConnect = { bprint(self.netname); bprint(" is here\n"); };
void() ClientDisconnect = { bprint(self.netname); bprint(" has left\n"); };
void() SetNewParms = { parm1 = 100; };
void() SetChangeParms = { parm1 = self.health + 1; };
void() PutClientInServer = {
  local entity spot;
  spot = find(world, classname, "info_player_start");
  self.classname = "player";
  self.health = parm1;
  self.movetype = 3; self.solid = 3; self.flags = 8; self.takedamage = 2;
  self.view_ofs = '0 0 22';
  setmodel(self, "progs/player.mdl");
  setsize(self, '-16 -16 -24', '16 16 32');
  setorigin(self, spot.origin + '0 0 1');
  self.angles = spot.angles;
  self.fixangle = 1;
};
)";

std::string source_file(std::string_view name) {
  const base::ByteVector bytes =
      read_file(std::filesystem::path(TEMBLOR_SOURCE_DIR) / "game/quakec" / std::string(name));
  return std::string(base::as_text(bytes));
}

}  // namespace

std::string small_program(std::string_view extra) {
  return source_file("system.qc") + source_file("builtins.qc") + std::string(extra) + std::string(kGame);
}

ServedGame::ServedGame(std::string_view program, const ServedGameOptions& options)
    : is_real_(options.is_real), network_(options.conditions, options.seed) {
  game_folder_.folder().write("id1/progs/player.mdl", "a server asks only whether it is there");
  replace_program(program);
  std::vector<std::string> games;
  if (!options.mod.empty()) {
    game_folder_.folder().write(options.mod + "/mod.txt", std::string_view("a folder exists by its files"));
    games.push_back(options.mod);
  }
  for (const auto& [name, text] : options.files) game_folder_.folder().write(name, text);
  auto files = vfs::FileSystem::open(game_folder_.path(), games);
  CHECK(files.ok(), "{}", files.error().message());
  library_ = std::make_unique<assets::Library>(std::move(*files));
  settings_ = std::make_unique<server::ServerVariables>(variables_);
  net::ServerEndpoint::Sockets sockets;
  sockets.push_back(open_socket(kServedAddress));
  if (is_real_) server_address_ = platform::ip4_address({127, 0, 0, 1}, sockets[0]->local_address().port);
  server_ = std::make_unique<server::Server>(server::ServerSetup{
      .library = *library_,
      .settings = *settings_,
      .sockets = std::move(sockets),
      .max_clients = options.max_clients,
      .write_folder = game_folder_.path() / "id1",
      .write_file = [](const std::filesystem::path& path, base::Bytes bytes) -> base::Status {
        std::ofstream(path, std::ios::binary)
            .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
        return base::Ok{};
      },
      .print = [this](std::string_view text) { console_ += text; },
      .seed = options.seed});
  const base::Status started = server::start_map(*server_, "small");
  CHECK(started.ok(), "{}", started.error().message());
}

void ServedGame::replace_program(std::string_view program) {
  game_folder_.folder().write("id1/progs.dat", compile_quakec(program));
}

std::unique_ptr<platform::DatagramSocket> ServedGame::open_socket(const platform::Address& address) {
  if (!is_real_) return network_.open(address);
  auto socket = platform::posix::open_udp_socket({.port = 0, .host = "127.0.0.1"});
  CHECK(socket.ok(), "{}", socket.error().message());
  return std::move(socket).value();
}

std::size_t ServedGame::add_client(std::string name) {
  const auto number = static_cast<std::uint8_t>(clients_.size() + 2);
  clients_.push_back(
      std::make_unique<client::Connection>(open_socket(platform::ip4_address({10, 0, 0, number}, 4000)),
                                           client::PlayerSettings{std::move(name), 4, 7}));
  prints_.emplace_back();
  sounds_.push_back(0);
  marks_.push_back(0);
  clients_.back()->connect(server_address_, now_s_);
  return clients_.size() - 1;
}

void ServedGame::advance_clock() {
  if (is_real_) {
    std::this_thread::sleep_for(std::chrono::duration<double>(1.0 / 72));
    const std::chrono::duration<double> since = std::chrono::steady_clock::now() - began_;
    now_s_ = kBegin_s + since.count();
  } else {
    now_s_ += 1.0 / 72;
    network_.advance_to(now_s_);
  }
}

void ServedGame::run(double seconds, const net::Move& move) {
  const double until_s = now_s_ + seconds;
  while (now_s_ < until_s) {
    advance_clock();
    server::step_server(*server_, now_s_);
    for (std::size_t i = 0; i < clients_.size(); ++i) {
      clients_[i]->update(now_s_);
      clients_[i]->send_move(move);
      for (const std::string& text : clients_[i]->state().events().prints) prints_[i] += text;
      for (const std::string& note : clients_[i]->state().events().notes) prints_[i] += note + "\n";
      sounds_[i] += clients_[i]->state().events().sounds.size();
      marks_[i] += clients_[i]->state().events().marks.size();
      clients_[i]->state().events().clear();
    }
  }
}

bool ServedGame::run_until_playing(std::size_t client) {
  for (int i = 0; i < 100 && !clients_[client]->is_playing(); ++i) run(0.1);
  return clients_[client]->is_playing();
}

}  // namespace temblor::test
