#include "lockstep/simulation/simulation.h"

#include <algorithm>
#include <utility>

#include "net/protocol/numbered_moves.h"
#include "net/transport/loopback.h"

namespace temblor::lockstep {
namespace {

constexpr std::uint16_t kServerPort = 1;
// Sums of tick lengths are rounded. A step that is longer by this factor contains a whole tick anyway,
// and a second one once in a billion.
constexpr double kStepPerTick = 1 + 1e-9;
// More than a handshake takes.
constexpr int kMaxConnectSteps = 50;

void set_variables(const GameStart& start, command::Variables& io_variables) {
  // A variable of another version, or out of its range, would have been refused with the start's version.
  for (const auto& [name, value] : start.variables) static_cast<void>(io_variables.set(name, value));
  for (const char* const name : {"sv_autosave", "sv_autoload", "sv_reload"})
    CHECK(io_variables.set(name, "0").ok(), "{} is not a server variable", name);
}

}  // namespace

Simulation::Simulation(const SimulationSetup& setup, const GameStart& start) : settings_(variables_) {
  set_variables(start, variables_);
  net::ServerEndpoint::Sockets sockets;
  sockets.push_back(network_.open(kServerPort));
  server_ = std::make_unique<server::Server>(
      server::ServerSetup{.library = setup.library,
                          .settings = settings_,
                          .sockets = std::move(sockets),
                          .max_clients = start.slots,
                          .oldest_protocol = net::Protocol::kRmq,
                          .program_file = setup.program_file,
                          .print = setup.print ? setup.print : [](std::string_view) {},
                          .prints_events = false,
                          .seed = start.seed});
}

Simulation::~Simulation() = default;

base::Result<std::unique_ptr<Simulation>> Simulation::begin(const SimulationSetup& setup,
                                                            const GameStart& start) {
  std::unique_ptr<Simulation> simulation(new Simulation(setup, start));
  TRY_STATUS(server::start_map(*simulation->server_, start.map));
  TRY_STATUS(simulation->connect_clients(start.players));
  simulation->input_age_s_ = static_cast<float>(start.delay_ticks * simulation->tick_s());
  simulation->ticks_ = 0;
  return simulation;
}

// One after the other, so that players get the slots of their numbers.
base::Status Simulation::connect_clients(std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    clients_.push_back({net::ClientEndpoint(network_.open())});
    clients_[i].endpoint.set_protocol(protocol());
    clients_[i].endpoint.connect(server_->endpoint.local_address(), now_s_);
    for (int steps = 0; server_->clients[i].is_free() && steps < kMaxConnectSteps; ++steps) {
      step();
      if (!server_->game) return base::error(base::ErrorCode::kUsage, "the game has ended at once");
    }
    CHECK(!server_->clients[i].is_free(), "client {} cannot connect over the loopback", i);
  }
  return base::Ok{};
}

void Simulation::step() {
  now_s_ += settings_.tick_s() * kStepPerTick;
  server::step_server(*server_, now_s_);
  receive_messages();
  ++ticks_;
}

void Simulation::receive_messages() {
  for (PretendedClient& client : clients_) {
    while (const std::optional<net::ClientEvent> event = client.endpoint.next_event(now_s_)) {
      if (const auto* message = std::get_if<net::FromServer>(&*event))
        client.messages.push_back(
            {base::ByteVector(message->bytes.begin(), message->bytes.end()), message->reliable});
      else if (std::holds_alternative<net::ConnectionLost>(*event))
        client.has_left = true;
    }
    client.endpoint.update(now_s_);
  }
}

// The server derives a player's ping from the time of a move: the age of what its client saw.
void Simulation::send_moves(PretendedClient& io_client, const ClientInput& input) {
  const auto time_s = static_cast<float>(server_->game->time_s()) - input_age_s_;
  for (std::size_t first = 0; first < input.moves.size(); first += net::kMaxMovesInPacket) {
    const std::size_t count = std::min(net::kMaxMovesInPacket, input.moves.size() - first);
    base::ByteWriter packet;
    if (input.last_number != 0) {
      const auto after = static_cast<std::uint32_t>(input.moves.size() - first - count);
      const std::string head = net::format_numbered_packet({.last_move = input.last_number - after});
      CHECK(net::write_client_message(net::StringCommand{head}, protocol(), packet).ok(), "{}", head);
    }
    for (net::Move move : std::span(input.moves).subspan(first, count)) {
      move.time_s = time_s;
      CHECK(net::write_client_message(move, protocol(), packet).ok(), "a move has numbers out of range");
    }
    static_cast<void>(io_client.endpoint.send_unreliable(packet.view()));
  }
}

// A failure to send means that the connection has ended, which the server knows as well.
void Simulation::send_input(PretendedClient& io_client, const ClientInput& input) {
  if (io_client.has_left) return;
  base::ByteWriter reliable;
  for (const std::string& line : input.commands)
    CHECK(net::write_client_message(net::StringCommand{line}, protocol(), reliable).ok(), "{}", line);
  if (reliable.size() > 0) static_cast<void>(io_client.endpoint.send_reliable(reliable.view()));
  send_moves(io_client, input);
  if (!input.leaves) return;
  io_client.endpoint.disconnect();
  io_client.has_left = true;
}

base::Status Simulation::play_tick(std::span<const ClientInput> inputs) {
  CHECK(inputs.size() == clients_.size(), "{} inputs for {} players", inputs.size(), clients_.size());
  if (!server_->game) return base::error(base::ErrorCode::kUsage, "the game code has failed");
  for (std::size_t i = 0; i < inputs.size(); ++i) send_input(clients_[i], inputs[i]);
  step();
  if (!server_->game) return base::error(base::ErrorCode::kUsage, "the game code has failed");
  return base::Ok{};
}

std::vector<MessageForClient> Simulation::take_messages(std::size_t player) {
  return std::exchange(clients_[player].messages, {});
}

}  // namespace temblor::lockstep
