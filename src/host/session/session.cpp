#include "host/session/session.h"

#include <fmt/format.h>

#include <algorithm>

namespace temblor::host {
namespace {

constexpr std::uint16_t kServerLoopbackPort = 1;

net::ServerEndpointSettings make_endpoint_settings(const Services& services) {
  net::ServerEndpointSettings settings;
  settings.secret = services.secret;
  return settings;
}

}  // namespace

Session::Session(Services& services, const assets::Library& library, std::filesystem::path write_folder,
                 const server::ServerVariables& settings, std::filesystem::path program_file)
    : services_(services),
      library_(library),
      write_folder_(std::move(write_folder)),
      settings_(settings),
      program_file_(std::move(program_file)) {}

Session::~Session() {
  disconnect("The host has left.");
}

server::ServerSetup Session::make_setup(net::ServerEndpoint::Sockets sockets, std::uint32_t max_clients) {
  return {
      .library = library_,
      .settings = settings_,
      .sockets = std::move(sockets),
      .wire = make_endpoint_settings(services_),
      .max_clients = max_clients,
      // Others join a player's game with newer programs, as a rule, and the player wants to see all of it.
      .oldest_protocol = max_clients == 1 ? net::Protocol::kRmq : net::Protocol::kFitzQuake,
      .program_file = program_file_,
      .write_folder = write_folder_,
      .write_file = services_.write_file,
      .print = [this](std::string_view text) { server_output_ += text; },
      .prints_events = false,
      .seed = services_.seed};
}

base::Status Session::open_server(std::uint32_t max_clients, std::uint16_t port,
                                  const client::PlayerSettings& player, double now_s) {
  if (server_ && max_clients_ == max_clients) return base::Ok{};
  // Close an old server that others may join first: the new one needs its port.
  if (server_ && max_clients_ > 1) disconnect("The host has started another game.");
  net::ServerEndpoint::Sockets sockets;
  net::LoopbackNetwork network;
  sockets.push_back(network.open(kServerLoopbackPort));
  const platform::Address local = sockets.front()->local_address();
  if (max_clients > 1) {
    if (!services_.open_socket)
      return base::error(base::ErrorCode::kUsage,
                         "a multiplayer game needs a network, and none is available");
    TRY(std::unique_ptr<platform::DatagramSocket> socket, services_.open_socket(port));
    sockets.push_back(std::move(socket));
  }
  // A single-player game is closed only here, so that it continues if the port is not free.
  disconnect("The host has started another game.");
  network_ = network;
  server_ = std::make_unique<server::Server>(make_setup(std::move(sockets), max_clients));
  max_clients_ = max_clients;
  connection_.emplace(network_->open(), player);
  connection_->connect(local, now_s);
  return base::Ok{};
}

base::Status Session::connect(std::string_view address, const client::PlayerSettings& player, double now_s) {
  if (!services_.open_socket || !services_.look_up)
    return base::error(base::ErrorCode::kUsage, "no network is available");
  TRY(const platform::Address server, services_.look_up(address, kDefaultPort));
  TRY(std::unique_ptr<platform::DatagramSocket> socket, services_.open_socket(0));
  disconnect("");
  connection_.emplace(std::move(socket), player);
  connection_->connect(server, now_s);
  return base::Ok{};
}

void Session::open_lockstep(std::unique_ptr<lockstep::LockstepGame> game,
                            const client::PlayerSettings& player, double now_s) {
  disconnect("The host has started another game.");
  lockstep_ = std::move(game);
  connection_.emplace(lockstep_->open_client_socket(), player);
  connection_->connect(lockstep_->client_server(), now_s);
}

void Session::disconnect(std::string_view reason) {
  if (connection_) connection_->disconnect();
  connection_.reset();
  if (lockstep_ && lockstep_->replay() != nullptr) replay_ = lockstep_->replay()->finish();
  lockstep_.reset();
  if (server_) server::shut_down(*server_, reason);
  server_.reset();
  network_.reset();
  max_clients_ = 0;
  time_s_ = 0;
}

std::optional<std::string> Session::read(double now_s) {
  const double passed_s = std::max(0.0, now_s - now_s_);
  now_s_ = now_s;
  if (!connection_) return std::nullopt;
  connection_->update(now_s);
  if (!connection_->is_connecting() && !connection_->is_connected()) {
    std::string reason = connection_->disconnect_reason();
    if (connection_->is_recording())
      lost_recording_ = connection_->finish_recording().value_or(base::ByteVector());
    disconnect("");
    return reason;
  }
  // Advance at the rate of our own clock, so that network jitter does not show, but stay between the last two
  // snapshots.
  const client::ClientState& state = connection_->state();
  time_s_ = std::clamp(time_s_ + passed_s * time_scale_, state.previous_time_s(),
                       std::max(state.previous_time_s(), state.time_s()));
  return std::nullopt;
}

// step_server() runs at the end of a frame, so its clock is extended to the current time.
double Session::move_clock_s(double now_s) const {
  return server_ ? server_now_s_ + (now_s - stepped_s_) * time_scale_ : now_s;
}

// A server that numbers moves simulates exactly one per tick. With our own server, the moves are aligned with
// its ticks: each is sent in the frame that runs its tick, just before it, with the newest input.
int Session::count_due_moves(const net::Move& next, double now_s) {
  if (!is_playing()) return 0;
  const double clock_s = move_clock_s(now_s);
  const double until_tick_s = server_ ? server::time_until_next_tick_s(*server_, clock_s) : 0;
  if (!connection_->move_parameters()) return server_ ? until_tick_s <= 0 : move_pacer_.is_due(next, now_s);
  if (until_tick_s > 0)
    connection_->align_moves(clock_s + until_tick_s - connection_->move_parameters()->tick_s);
  return connection_->count_due_moves(clock_s);
}

void Session::send_move(net::Move move, double now_s) {
  move_pacer_.note_sent(move, now_s);
  connection_->send_move(move);
}

void Session::step_server(double now_s, bool halted) {
  if (lockstep_) lockstep_->step(now_s);
  if (!server_) return;
  if (!halted) server_now_s_ += std::max(0.0, now_s - stepped_s_) * time_scale_;
  stepped_s_ = now_s;
  server::step_server(*server_, server_now_s_);
}

}  // namespace temblor::host
