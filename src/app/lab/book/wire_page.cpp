#include "app/lab/book/wire_page.h"

#include <fmt/format.h>

#include "app/files/atomic_write.h"
#include "app/html/html.h"

namespace temblor::app {
namespace {

namespace wire = lab::wire;
using wire::Method;

constexpr const char* kWireExplanation =
    "<p class=\"soft\"><code>temblor lab wire</code></p>\n"
    "<p>A server computes the game, and each player's computer shows it. Between them is a network that "
    "delays packets and loses some. Five ways to cross it carry the same recorded game here, over the same "
    "network, in virtual time. Every state that a player is shown was decoded from packets, and equals the "
    "recorded one. Start with <code>simulate</code> in <code>src/lab/wire</code>.</p>\n";

constexpr const char* kWireClaim =
    "<h3>The article's claim</h3>\n<p>In the early stages of Quake, every packet was reliable, because it "
    "held "
    "only changes. At a round trip of 200 ms, a lost packet stopped the game for several hundred "
    "milliseconds. With whole states, sent unreliably, it costs one time slice of the server: 100 ms or "
    "less at 10 or 20 of them per second. <span class=\"soft\">(Quake's 3-D Engine: The Big "
    "Picture)</span></p>\n";

struct MethodText {
  Method method;
  const char* text;
};

constexpr MethodText kMethodTexts[] = {
    {Method::kReliable,
     "A state is sent as its difference from the one before, so none may be missing. The next one leaves "
     "when "
     "an acknowledgment has come back. Even without loss, the world moves once per round trip; after a loss, "
     "it stands until the sender gives up waiting, and the packet is sent again. The packets are those of "
     "the engine's channel, and Temblor's server still can do it: <code>sv_reliableupdates 1</code>."},
    {Method::kWindow,
     "The same differences, one per tick, without waiting. A lost one is sent again as soon as three later "
     "ones have arrived. They are useless until then, and then all come at once: the world stands for more "
     "than a round trip, and jumps. TCP also does that, and would send more slowly afterwards."},
    {Method::kWholeState,
     "Each packet holds everything that differs from the level's first state. Nobody asks whether it has "
     "arrived, because the next one replaces it. That costs the most bytes."},
    {Method::kDeltas,
     "The client says which states have arrived, and the server sends differences from one of those. So no "
     "packet needs one that was lost. The longer the round trip, the older that state, and the larger the "
     "differences. Temblor's clients also send each move four times, so they send more than stock ones."},
    {Method::kLockstep,
     "Every peer computes the whole game from the inputs of all. An input is played a fixed time after it "
     "was "
     "given, a little longer than the way to the others, and each packet repeats the last four inputs. So a "
     "lost one usually costs nothing. But nobody sees an own input earlier, everybody waits for the slowest, "
     "and each peer sends to all others. Bytes do not depend on how much happens in the game."}};

// A row of numbers, each with a class.
std::string make_row(std::string_view head, const std::vector<std::string>& cells) {
  std::string html = fmt::format("<tr><td>{}</td>", escape_html(head));
  for (const std::string& cell : cells) html += fmt::format("<td class=\"n\">{}</td>", cell);
  return html + "</tr>\n";
}

std::string make_head(std::string_view head, const std::vector<std::string>& cells) {
  std::string html = fmt::format("<table>\n<tr><th>{}</th>", head);
  for (const std::string& cell : cells) html += fmt::format("<th class=\"n\">{}</th>", cell);
  return html + "</tr>\n";
}

std::vector<double> list_measured_pings(const WireResults& results) {
  std::vector<double> pings_ms;
  for (const WireFreeze& freeze : results.freezes)
    if (freeze.method == Method::kReliable) pings_ms.push_back(freeze.ping_ms);
  return pings_ms;
}

std::string make_verdict(const WireResults& results) {
  constexpr double kSeveralHundred_ms = 200, kOneSlice_ms = 100;
  const double ping_ms = choose_plotted_ping(results);
  const double reliable_ms = results.freeze(Method::kReliable, ping_ms).frozen_ms();
  const WireFreeze& slowest = results.slower.back();
  const bool holds = reliable_ms >= kSeveralHundred_ms && slowest.frozen_ms() <= kOneSlice_ms;
  return fmt::format(
      "<h3>Our measurement: the claim <span class=\"{}\">{}</span></h3>\n<p>At a round trip of {:g} ms, a "
      "lost "
      "packet freezes the world for {:.0f} ms if everything is reliable, and for {:.0f} ms with whole states "
      "at {:.0f} ticks per second. At {:.0f} ticks, it is {:.0f} ms: one tick.</p>\n",
      holds ? "good" : "no", holds ? "holds" : "does not hold", ping_ms, reliable_ms,
      results.freeze(Method::kWholeState, ping_ms).frozen_ms(), 1 / results.tick_s, 1000 / slowest.tick_ms,
      slowest.frozen_ms());
}

std::string make_freeze_table(const WireResults& results) {
  const std::vector<double> pings_ms = list_measured_pings(results);
  std::vector<std::string> heads;
  for (const double ping_ms : pings_ms) heads.push_back(fmt::format("{:g} ms", ping_ms));
  std::string html =
      "<h3>One lost packet</h3>\n<p>The longest time without a newer state, in ms: without loss, and with "
      "the "
      "loss of one packet. Columns are round trips.</p>\n" +
      make_head("method", heads);
  for (const wire::MethodInfo& info : wire::list_methods()) {
    std::vector<std::string> cells;
    for (const double ping_ms : pings_ms) {
      const WireFreeze& freeze = results.freeze(info.method, ping_ms);
      cells.push_back(fmt::format("{:.0f}; {:.0f}", freeze.gap_ms, freeze.lost_gap_ms));
    }
    html += make_row(info.title, cells);
  }
  return html + "</table>\n";
}

std::string make_link_table(const WireResults& results, double ping_ms) {
  std::string html = fmt::format("<h3>Random loss, round trip {:g} ms</h3>\n", ping_ms) +
                     make_head("method", {"lost", "KB/s in", "KB/s out", "packets/s in, out",
                                          "newer state after, ms: median", "99%", "worst",
                                          "input to picture, ms: median", "99%"});
  for (const WireFigures& f : results.figures)
    if (f.ping_ms == ping_ms)
      html += make_row(
          find_method_info(f.method).name,
          {fmt::format("{:g} %", f.loss * 100), fmt::format("{:.1f}", f.bytes_in / 1000),
           fmt::format("{:.1f}", f.bytes_out / 1000),
           fmt::format("{:.0f}, {:.0f}", f.packets_in, f.packets_out), fmt::format("{:.0f}", f.gap_ms.p50),
           fmt::format("{:.0f}", f.gap_ms.p99), fmt::format("{:.0f}", f.gap_ms.max),
           fmt::format("{:.0f}", f.picture_ms.p50), fmt::format("{:.0f}", f.picture_ms.p99)});
  return html + "</table>\n";
}

std::string make_wire_page(const WireResults& results) {
  std::string html =
      begin_page("The wire", std::string(kPlotStyle) +
                                 "a { color: var(--bar); } .no { color: var(--alarm); } td:first-child { "
                                 "white-space: nowrap; } th, th.n { white-space: "
                                 "normal; vertical-align: bottom; }") +
      "<p><a href=\"index.html\">The laboratory's book</a></p>\n<h1>The wire</h1>\n" + kWireExplanation +
      kWireClaim + make_verdict(results) + make_freeze_table(results);
  for (const Plot& plot : plot_wire(results)) html += draw_plot(plot);
  for (const MethodText& text : kMethodTexts)
    html +=
        fmt::format("<h3>{}</h3>\n<p>{}</p>\n", escape_html(find_method_info(text.method).title), text.text);
  for (const double ping_ms : list_measured_pings(results)) html += make_link_table(results, ping_ms);
  html += fmt::format(
      "<p class=\"soft\">{}, {} players, {} runs of {:.0f} s at {:.0f} ticks per second. Each packet counts "
      "{} bytes of "
      "IP "
      "and UDP, and delays vary by {:g} ms. \"In\" is what one player receives. A picture comes 60 times per "
      "second. Input to picture is without prediction, which hides it for the player's own movement with "
      "whole states and with deltas, but not for doors, shots, and other players. A peer in lockstep cannot "
      "predict, because its world is already the right one.</p>\n",
      escape_html(results.world), results.players, kWireRuns,
      static_cast<double>(results.ticks) * results.tick_s, 1 / results.tick_s, wire::kInternetHeaderBytes,
      kWireJitter_ms);
  return html + "</body>\n</html>\n";
}

}  // namespace

base::Status write_wire_page(const std::filesystem::path& folder, const WireResults& results) {
  return replace_file(folder / "wire.html", base::as_bytes(make_wire_page(results)));
}

}  // namespace temblor::app
