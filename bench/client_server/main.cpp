// Measures the cost of a server with many monsters, with many clients, and during a change of level. Compares
// the CPU time of the process with the simulated time, so that other work on the machine has little effect.
//
// Usage: client_server_bench PROGS, with the basedir in TEMBLOR_DATA.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <string>
#include <vector>

#include "bench/client_server/crowd.h"
#include "client/session/connection.h"
#include "server/move_trace.h"
#include "server/server.h"
#include "support/programs/bad_network.h"
#include "support/random.h"

namespace temblor {
namespace {

constexpr double kTick_s = 1.0 / 72;
constexpr std::size_t kMonsters = 600;
constexpr int kClients = 64;

double cpu_s() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

void fail(const base::Error& error) {
  fmt::print(stderr, "client_server_bench: {}\n", error.message());
  std::exit(1);
}

// A server of the shipped game with its clients, on a network without losses.
class Bench {
 public:
  Bench(const std::filesystem::path& data, const std::filesystem::path& progs, std::uint32_t max_clients)
      : library_(vfs::FileSystem::open(data).value()), settings_(variables_), network_({}, 1) {
    net::ServerEndpoint::Sockets sockets;
    sockets.push_back(network_.open(kServer));
    server_ = std::make_unique<server::Server>(server::ServerSetup{.library = library_,
                                                                   .settings = settings_,
                                                                   .sockets = std::move(sockets),
                                                                   .max_clients = max_clients,
                                                                   .program_file = progs,
                                                                   .print = [](std::string_view) {}});
  }

  void start(std::string_view map) {
    if (const base::Status status = server::start_map(*server_, map); !status.ok()) fail(status.error());
  }
  server::Server& server() { return *server_; }
  command::Variables& variables() { return variables_; }
  // CPU seconds of the server's steps, without those of the clients.
  double play(double seconds, bool clients_move) {
    double server_cpu_s = 0;
    for (const double until_s = now_s_ + seconds; now_s_ < until_s;) {
      now_s_ += kTick_s;
      network_.advance_to(now_s_);
      const double before_s = cpu_s();
      server::step_server(*server_, now_s_);
      server_cpu_s += cpu_s() - before_s;
      for (std::size_t i = 0; i < clients_.size(); ++i) {
        clients_[i]->update(now_s_);
        clients_[i]->state().events().clear();
        const auto yaw =
            static_cast<float>(static_cast<int>(now_s_ * 90 + static_cast<double>(i) * 37) % 360);
        clients_[i]->send_move(clients_move ? net::Move{.angles_deg = {0, yaw, 0}, .forward = 400}
                                            : net::Move{});
      }
    }
    return server_cpu_s;
  }
  void join(int count) {
    for (int i = 0; i < count; ++i) {
      addresses_.push_back(platform::ip4_address({10, 0, 1, static_cast<std::uint8_t>(i + 1)},
                                                 static_cast<std::uint16_t>(4000 + i)));
      clients_.push_back(std::make_unique<client::Connection>(
          network_.open(addresses_.back()), client::PlayerSettings{fmt::format("p{}", i), 1, 2}));
      clients_.back()->connect(kServer, now_s_);
      play(0.2, false);
      lead_away(static_cast<std::size_t>(i));
    }
    play(5, false);
  }
  void set_delay(double delay_s) {
    network_.set_conditions({.delay_s = delay_s});
    play(2, false);
  }
  std::size_t playing() const {
    std::size_t count = 0;
    for (const auto& client : clients_) count += client->is_playing() ? 1 : 0;
    return count;
  }
  // The positions of the living players.
  std::vector<math::Vec3> places_of_players() {
    std::vector<math::Vec3> places;
    for (std::size_t slot = 0; slot < clients_.size(); ++slot) {
      const server::Edict player = server_->game->player(slot);
      if (player[server::field::kHealth] > 0) places.push_back(player[server::field::kOrigin]);
    }
    return places;
  }
  // Over all clients.
  std::uint64_t updates() const {
    std::uint64_t count = 0;
    for (const auto& client : clients_) count += client->updates();
    return count;
  }
  std::uint64_t bytes_to_clients() const {
    std::uint64_t bytes = 0;
    for (const platform::Address& address : addresses_) bytes += network_.bytes_sent_to(address);
    return bytes;
  }

 private:
  // Moves a player away from the few spawn points, so that the next player does not telefrag it.
  void lead_away(std::size_t slot) {
    server::GameWorld& world = server_->game->world();
    const server::Edict player = server_->game->player(slot);
    const math::Vec3 from = player[server::field::kOrigin];
    for (int attempt = 0; attempt < 1000; ++attempt) {
      math::Vec3 place = from;
      for (int way = 0; way < 12; ++way)
        place = server::trace_move(world, place, player[server::field::kMins], player[server::field::kMaxs],
                                   place + random_.in_cube(600) * math::Vec3{1, 1, 0.5f},
                                   server::MoveKind::kNoMonsters, player.index())
                    .trace.end;
      player.set(server::field::kOrigin, place);
      if (server::is_stuck(world, player.index())) continue;
      if (const auto linked = server::link(world, player.index(), server::TouchTriggers::kNo); !linked.ok())
        fail(linked.error());
      return;
    }
    std::abort();
  }

  static inline const platform::Address kServer = platform::ip4_address({10, 0, 0, 1}, 26000);
  command::Variables variables_;
  assets::Library library_;
  server::ServerVariables settings_;
  test::BadNetwork network_;
  std::unique_ptr<server::Server> server_;
  std::vector<platform::Address> addresses_;
  std::vector<std::unique_ptr<client::Connection>> clients_;
  test::Random random_{7};
  double now_s_ = 1;
};

std::vector<math::Vec3> places_of_monsters(server::Game& io_game) {
  std::vector<math::Vec3> places;
  for (const vm::EntityIndex monster : bench::list_monsters(io_game.world()))
    places.push_back(io_game.world().edicts[monster][server::field::kOrigin]);
  return places;
}

std::size_t count_moved(const std::vector<math::Vec3>& before, const std::vector<math::Vec3>& after) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < std::min(before.size(), after.size()); ++i)
    count += glm::distance(before[i], after[i]) > 32 ? 1 : 0;
  return count;
}

void bench_monsters(const std::filesystem::path& data, const std::filesystem::path& progs, bool hunt) {
  for (const char* map : {"lq_e0m1", "lq_e1m2"}) {
    Bench served(data, progs, 4);
    if (!served.variables().set("sv_protocol", "666").ok()) std::abort();
    served.start(map);
    served.join(1);
    server::Game& game = *served.server().game;
    if (const base::Status added = bench::add_monsters(kMonsters, game); !added.ok()) fail(added.error());
    if (hunt)
      if (const base::Status set = bench::set_upon_player(game); !set.ok()) fail(set.error());
    served.play(1, true);
    const std::vector<math::Vec3> places = places_of_monsters(game);
    const std::uint64_t before = game.machine().instructions_run();
    constexpr double kPlayed_s = 20;
    const double cost_s = served.play(kPlayed_s, true);
    const auto instructions = static_cast<double>(game.machine().instructions_run() - before);
    const std::vector<math::Vec3> later = places_of_monsters(game);
    fmt::print(
        "| {} monsters {} on {}, {} went somewhere | {:.1f} % of a core | {:.2f} M QuakeC instructions a "
        "second |\n",
        later.size(), hunt ? "hunt" : "look out", map, count_moved(places, later), 100 * cost_s / kPlayed_s,
        instructions / kPlayed_s / 1e6);
  }
}

// `max_rate` is in bytes per second to each client; 0 means no limit. `delay_s` is the network's one-way
// delay.
void bench_clients(const std::filesystem::path& data, const std::filesystem::path& progs, int max_rate,
                   double delay_s) {
  for (const bool they_move : {true, false}) {
    Bench bench(data, progs, kClients);
    if (!bench.variables().set("deathmatch", "1").ok()) std::abort();
    if (!bench.variables().set("sv_maxrate", std::to_string(max_rate)).ok()) std::abort();
    bench.start("lqdm5");
    bench.join(kClients);
    bench.set_delay(delay_s);
    const std::uint64_t before = bench.bytes_to_clients(), updates_before = bench.updates();
    constexpr double kPlayed_s = 20;
    const double cost_s = bench.play(kPlayed_s, they_move);
    const double updates = static_cast<double>(bench.updates() - updates_before) / kPlayed_s / kClients;
    const double bytes = static_cast<double>(bench.bytes_to_clients() - before) / kPlayed_s / kClients;
    const std::vector<math::Vec3> places = bench.places_of_players();
    bench.play(0.3, they_move);
    fmt::print(
        "| {} clients, {} alive, {} {} on lqdm5, sv_maxrate {}, {:.0f} ms there and back | {:.1f} % of a "
        "core | {:.1f} KB and {:.0f} "
        "updates a second to each |\n",
        bench.playing(), places.size(), count_moved(places, bench.places_of_players()),
        they_move ? "run" : "stand", max_rate, 2000 * delay_s, 100 * cost_s / kPlayed_s, bytes / 1000,
        updates);
  }
}

void bench_quiet(const std::filesystem::path& data, const std::filesystem::path& progs) {
  Bench bench(data, progs, 4);
  bench.start("lq_e1m2");
  bench.join(1);
  const std::uint64_t before = bench.bytes_to_clients();
  constexpr double kPlayed_s = 20;
  const double cost_s = bench.play(kPlayed_s, false);
  fmt::print("| one client stands on lq_e1m2 | {:.1f} % of a core | {:.1f} KB a second |\n",
             100 * cost_s / kPlayed_s,
             static_cast<double>(bench.bytes_to_clients() - before) / kPlayed_s / 1000);
}

void bench_level_change(const std::filesystem::path& data, const std::filesystem::path& progs) {
  Bench bench(data, progs, 4);
  bench.start("start");
  std::vector<double> seconds;
  for (int i = 0; i < 9; ++i) {
    const auto begin = std::chrono::steady_clock::now();
    if (const auto status = server::change_level(bench.server(), "lq_e1m2"); !status.ok())
      fail(status.error());
    seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  }
  std::sort(seconds.begin(), seconds.end());
  fmt::print("| change of level to lq_e1m2 | {:.0f} ms | {:.0f} ms at most |\n", seconds[4] * 1000,
             seconds.back() * 1000);
}

}  // namespace
}  // namespace temblor

int main(int argument_count, char** arguments) {
  const char* data = std::getenv("TEMBLOR_DATA");
  if (argument_count != 2 || !data) {
    fmt::print(stderr, "usage: client_server_bench PROGS, with TEMBLOR_DATA naming the base folder\n");
    return 2;
  }
  temblor::bench_monsters(data, arguments[1], false);
  temblor::bench_monsters(data, arguments[1], true);
  temblor::bench_clients(data, arguments[1], 0, 0);
  temblor::bench_clients(data, arguments[1], 0, 0.05);
  temblor::bench_clients(data, arguments[1], 5000, 0.05);
  temblor::bench_quiet(data, arguments[1]);
  temblor::bench_level_change(data, arguments[1]);
  return 0;
}
