#include "host/session/session.h"

#include <fmt/format.h>

#include <algorithm>

namespace temblor::host {
namespace {

constexpr double kMovesEvery_s = 1.0 / 72;
constexpr std::uint16_t kServerLoopbackPort = 1;

net::ServerEndpointSettings wire_settings(const Services& services) {
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

server::ServerSetup Session::setup_for(net::ServerEndpoint::Sockets sockets, std::uint32_t max_clients) {
  return {.library = library_,
          .settings = settings_,
          .sockets = std::move(sockets),
          .wire = wire_settings(services_),
          .max_clients = max_clients,
          .program_file = program_file_,
          .write_folder = write_folder_,
          .write_file = services_.write_file,
          .print = [this](std::string_view text) { server_output_ += text; },
          .prints_events = false,
          .seed = services_.seed};
}

base::Status Session::open_server(std::uint32_t max_clients, std::uint16_t port,
                                  const client::PlayerSettings& player) {
  if (server_ && max_clients_ == max_clients) return base::Ok{};
  // The port that the one before has is wanted again.
  if (server_ && max_clients_ > 1) disconnect("The host has begun another game.");
  net::ServerEndpoint::Sockets sockets;
  net::LoopbackNetwork network;
  sockets.push_back(network.open(kServerLoopbackPort));
  const platform::Address local = sockets.front()->local_address();
  if (max_clients > 1) {
    if (!services_.open_socket)
      return base::error(base::ErrorCode::kUsage, "there is no network for a game of several players");
    TRY(std::unique_ptr<platform::DatagramSocket> socket, services_.open_socket(port));
    sockets.push_back(std::move(socket));
  }
  disconnect("The host has begun another game.");
  network_ = network;
  server_ = std::make_unique<server::Server>(setup_for(std::move(sockets), max_clients));
  max_clients_ = max_clients;
  connection_.emplace(network_->open(), player);
  connection_->connect(local, now_s_);
  return base::Ok{};
}

base::Status Session::connect(std::string_view address, const client::PlayerSettings& player) {
  if (!services_.open_socket || !services_.look_up)
    return base::error(base::ErrorCode::kUsage, "there is no network here");
  TRY(const platform::Address server, services_.look_up(address, kStockPort));
  TRY(std::unique_ptr<platform::DatagramSocket> socket, services_.open_socket(0));
  disconnect("");
  connection_.emplace(std::move(socket), player);
  connection_->connect(server, now_s_);
  return base::Ok{};
}

void Session::disconnect(std::string_view reason) {
  if (connection_) connection_->disconnect();
  connection_.reset();
  if (server_) server_->shut_down(reason);
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
    std::string reason = connection_->lost_because();
    lost_recording_ = connection_->finish_recording();
    disconnect("");
    return reason;
  }
  // Between the last two updates, at the pace of the clock here, whatever the way there does to theirs.
  const client::ClientState& state = connection_->state();
  time_s_ = std::clamp(time_s_ + passed_s, state.previous_time_s(),
                       std::max(state.previous_time_s(), state.time_s()));
  return std::nullopt;
}

double Session::move_clock_s(double now_s) const {
  return server_ ? server_now_s_ + (now_s - stepped_s_) : now_s;
}

int Session::moves_due(double now_s) {
  if (!is_playing()) return 0;
  const double clock_s = move_clock_s(now_s);
  const double until_tick_s = server_ ? server_->until_next_tick_s(clock_s) : 0;
  if (!connection_->move_parameters())
    return until_tick_s <= 0 && (server_ || now_s - moved_s_ >= kMovesEvery_s);
  if (until_tick_s > 0)
    connection_->align_moves(clock_s + until_tick_s - connection_->move_parameters()->tick_s);
  return connection_->moves_due(clock_s);
}

void Session::send_move(net::Move move, double now_s) {
  moved_s_ = now_s;
  connection_->send_move(move);
}

void Session::step_server(double now_s, bool halted) {
  if (!server_) return;
  if (!halted) server_now_s_ += std::max(0.0, now_s - stepped_s_);
  stepped_s_ = now_s;
  server_->step(server_now_s_);
}

}  // namespace temblor::host
