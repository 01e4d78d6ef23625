// The nodes of each method. A node is a program on one computer: its clock calls step() once per tick, and
// the network calls receive(). It knows its packets, the time, and, if it is the server, the world.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "base/function_ref.h"
#include "lab/wire.h"
#include "lab/wire/record.h"
#include "net/protocol/client_message.h"

namespace temblor::lab::wire {

// Sends a packet to a node.
using Send = base::FunctionRef<void(std::size_t to, base::Bytes packet)>;

class Node {
 public:
  virtual ~Node() = default;
  // Steps count from 0. After the last tick of the world they go on, so that lost packets are resent.
  virtual void step(std::size_t number, double now_s, Send send) = 0;
  virtual void receive(std::size_t from, base::Bytes packet, double now_s, Send send) = 0;
};

using Nodes = std::vector<std::unique_ptr<Node>>;

// The server is node 0. The viewer is node 1: the client, or a peer.
constexpr std::size_t kServer = 0, kViewer = 1;

struct Parts {
  const World& world;
  const Setup& setup;
  Record& record;  // outlives the nodes
};

// The nodes of a method with a server and a client.
template <class Server, class Client>
Nodes make_server_and_client(const Parts& parts) {
  Nodes nodes;
  nodes.push_back(std::make_unique<Server>(parts));
  nodes.push_back(std::make_unique<Client>(parts));
  return nodes;
}

// Deltas from the state that was sent last, and moves, in reliable messages of the engine's channel: one in
// flight at a time, in order. The server sends the newest state as soon as nothing is in flight, as with
// sv_reliableupdates.
Nodes make_reliable_nodes(const Parts& parts);
// The same messages, one per tick, in a window with selective acknowledgments (wire/window.h).
Nodes make_window_nodes(const Parts& parts);
// Stock NetQuake: all that differs from the baselines, in each tick, unreliably.
Nodes make_whole_state_nodes(const Parts& parts);
// The engine's own clients: deltas from a state that the client has acknowledged, and numbered moves.
Nodes make_delta_nodes(const Parts& parts);
// Peers that send only inputs, and compute the world themselves (wire/lockstep.cpp).
Nodes make_lockstep_nodes(const Parts& parts);

// How many ticks after it is given an input is played: long enough for it to arrive twice before that tick.
std::size_t find_input_delay(const Link& link, double tick_s);

// A move with the number of its input where the wanted speed would be.
net::Move make_move(std::size_t input, float time_s);
std::size_t find_input(const net::Move& move);

}  // namespace temblor::lab::wire
