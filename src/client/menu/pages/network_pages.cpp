// Multiplayer pages: join, host, and the player's name and colors.
#include <fmt/format.h>

#include <algorithm>

#include "client/menu/lettering.h"
#include "client/menu/page.h"
#include "client/menu/rows/choice_rows.h"
#include "client/menu/rows/option_rows.h"
#include "client/menu/rows/plain_rows.h"
#include "client/menu/rows/text_row.h"
#include "command/text.h"

namespace temblor::client {
namespace {

constexpr int kMaxPlayers = 16, kMinPlayers = 2;
constexpr int kCaptureTheFlag = 3;  // of the variable "teamplay"

// The palette rows that the stock picture of the player uses for shirt and pants.
constexpr int kRowShades = 16, kShirtRow = 1, kPantsRow = 6;

constexpr std::string_view kBotFill = "bot_fill";
constexpr std::string_view kShirt = "topcolor", kPants = "bottomcolor";

// Returns a color variable's palette row, 0 to 15; `fallback` if it is not registered.
int read_palette_row(const command::Variables& variables, std::string_view name, int fallback) {
  const command::Variable* const color = variables.find(name);
  return color == nullptr ? fallback : static_cast<int>(color->number) & 15;
}

// Returns the same shade in another palette row. Rows from the eighth on run from bright to dark.
std::uint8_t move_to_row(int row, std::uint8_t pixel) {
  constexpr int kFirstReversed = 8;
  const int shade = pixel % kRowShades;
  return static_cast<std::uint8_t>(row * kRowShades +
                                   (row < kFirstReversed ? shade : kRowShades - 1 - shade));
}

Outcome connect(const PageContext& context, const std::string& address) {
  if (address.empty()) return {};
  return confirm_if_unsaved(
      context, "Connect anyway?",
      {.commands = {command::join_words({"connect", address})}, .leaving = Leaving::kClose});
}

std::unique_ptr<Row> make_address_row(const PageContext& context) {
  return std::make_unique<TextRow>("Address",
                                   TextRow::Parts{.read = [context] { return context.choices.address; },
                                                  .write =
                                                      [context](std::string address) {
                                                        context.choices.address = address;
                                                        return connect(context, address);
                                                      },
                                                  .help = "Server address: host or IP, optionally :port.",
                                                  .clipboard = context.content.clipboard});
}

// Aligns the three right columns of the list of servers: level, players, ping.
std::string format_server_columns(std::string_view level, std::string_view players, std::string_view ping) {
  constexpr std::size_t kLevel = 8, kPlayers = 7, kPing = 5;
  // Pads by bytes, as each byte is one character on the screen.
  const auto pad = [](std::size_t chars, const std::string& text) {
    return std::string(chars - text.size(), ' ');
  };
  const std::string first = truncate(level, kLevel), second = truncate(players, kPlayers),
                    third = truncate(ping, kPing);
  return first + pad(kLevel, first) + ' ' + pad(kPlayers, second) + second + ' ' + pad(kPing, third) + third;
}

std::unique_ptr<Row> make_server_row(const PageContext& context, const MenuServer& server) {
  return std::make_unique<ListRow>(ListEntry{
      .left = server.name.empty() ? server.address : server.name,
      .right = format_server_columns(server.level, fmt::format("{}/{}", server.players, server.max_players),
                                     fmt::format("{}ms", server.ping_ms)),
      .choose = [context, address = server.address] { return connect(context, address); },
      .help = fmt::format("{}: {}", server.address, server.name)});
}

std::string find_level_title(const PageContext& context, const std::string& level) {
  for (const MenuLevel& found : call_or_default(context.content.levels))
    if (found.name == level && !found.title.empty()) return found.title;
  return level;
}

// A list of levels; choosing one returns to the host page.
Page make_host_level_page(const PageContext& context) {
  Page page;
  page.title = "Level";
  page.style = PageStyle::kDetails;
  page.has_search = true;
  page.empty_text = "No levels found.";
  for (const MenuLevel& level : call_or_default(context.content.levels)) {
    if (level.name.empty()) continue;
    if (level.name == context.choices.host.level) page.first_choice = page.rows.size();
    page.rows.push_back(make_level_row(context.content, level, [context, name = level.name] {
      context.choices.host.level = name;
      return Outcome{.leaving = Leaving::kBack};
    }));
  }
  return page;
}

// A row that shows the level of the game to host and opens the list of levels.
class LevelRow : public ActionRow {
 public:
  LevelRow(const std::string& name, const std::string& title)
      : ActionRow(
            "Level", [] { return Outcome{.page = make_host_level_page}; },
            fmt::format("{}: {}. Press Enter to choose another level.", name, title)),
        title_(title) {}
  void draw(const Canvas& canvas, const RowPlace& place) const override {
    draw_label_and_value(canvas, place, label(), title_, false);
  }

 private:
  std::string title_;
};

std::unique_ptr<Row> make_players_row(MenuChoices::Host& io_host) {
  LocalChoiceRow::Parts parts;
  for (int players = kMinPlayers; players <= kMaxPlayers; ++players)
    parts.names.push_back(fmt::format("{}", players));
  parts.chosen = [&io_host] { return io_host.players - kMinPlayers; };
  parts.choose = [&io_host](int number) { io_host.players = number + kMinPlayers; };
  parts.help = "Maximum number of players, including you.";
  return std::make_unique<LocalChoiceRow>("Max players", std::move(parts));
}

std::unique_ptr<Row> make_mode_row(MenuChoices::Host& io_host) {
  LocalChoiceRow::Parts parts;
  parts.names = {"deathmatch", "teams", "capture the flag", "co-op"};
  parts.chosen = [&io_host] { return static_cast<int>(io_host.mode); };
  parts.choose = [&io_host](int number) { io_host.mode = static_cast<HostMode>(number); };
  parts.help = "Each for itself, in teams by color, with two flags, or together against the monsters.";
  parts.refresh = true;
  return std::make_unique<LocalChoiceRow>("Game mode", std::move(parts));
}

std::unique_ptr<Row> make_friendly_fire_row(MenuChoices::Host& io_host) {
  LocalChoiceRow::Parts parts;
  parts.names = {"off", "on"};
  parts.chosen = [&io_host] { return io_host.has_friendly_fire ? 1 : 0; };
  parts.choose = [&io_host](int number) { io_host.has_friendly_fire = number != 0; };
  parts.help = "Whether teammates can hurt each other.";
  return std::make_unique<LocalChoiceRow>("Friendly fire", std::move(parts));
}

// The variable "teamplay" of game code.
int find_teamplay(const MenuChoices::Host& host) {
  if (host.mode == HostMode::kCaptureTheFlag) return kCaptureTheFlag;
  if (host.mode != HostMode::kTeams) return 0;
  return host.has_friendly_fire ? 2 : 1;
}

// A text field: a slider cannot hit one of 65536 ports.
std::unique_ptr<Row> make_port_row(command::Variables& io_variables) {
  const command::Variable* const port = io_variables.find("port");
  if (port == nullptr) return nullptr;
  return std::make_unique<TextRow>(
      "Port", TextRow::Parts{.read = [&io_variables] { return io_variables.find("port")->text; },
                             .write =
                                 [&io_variables](std::string text) {
                                   (void)io_variables.set("port", text);
                                   return Outcome{};
                                 },
                             .help = port->help});
}

// Bots fill a hosted deathmatch unless the player chooses otherwise. The console's `bot_fill` also counts.
int read_bot_fill(const PageContext& context) {
  constexpr int kDefaultFill = 4;
  if (context.choices.host.bot_fill) return *context.choices.host.bot_fill;
  const command::Variable* const variable = context.variables.find(kBotFill);
  const int fill = variable == nullptr ? 0 : static_cast<int>(variable->number);
  return fill == 0 ? kDefaultFill : fill;
}

// Null if the variable is not registered.
std::unique_ptr<Row> make_bot_fill_row(const PageContext& context) {
  constexpr int kMaxFill = 8;
  if (context.variables.find(kBotFill) == nullptr) return nullptr;
  LocalChoiceRow::Parts parts;
  parts.names = {"none"};
  // One player alone needs no bots.
  for (int players = 2; players <= kMaxFill; ++players) parts.names.push_back(fmt::format("{}", players));
  parts.chosen = [context] { return std::max(read_bot_fill(context) - 1, 0); };
  parts.choose = [context](int number) { context.choices.host.bot_fill = number == 0 ? 0 : number + 1; };
  parts.help = "Bots fill the game up to this many players, including you.";
  return std::make_unique<LocalChoiceRow>("Fill with bots", std::move(parts));
}

// `disconnect` ends a running game first: maxplayers applies to the next game that starts.
Outcome start_host_game(const PageContext& context) {
  const MenuChoices::Host& chosen = context.choices.host;
  const bool deathmatch = chosen.mode != HostMode::kCooperative;
  Outcome started{.leaving = Leaving::kClose};
  started.commands = {"disconnect", fmt::format("maxplayers {}", chosen.players),
                      fmt::format("deathmatch {}", deathmatch ? 1 : 0),
                      fmt::format("coop {}", deathmatch ? 0 : 1),
                      fmt::format("teamplay {}", find_teamplay(chosen))};
  if (deathmatch && context.variables.find(kBotFill) != nullptr)
    started.commands.push_back(fmt::format("{} {}", kBotFill, read_bot_fill(context)));
  started.commands.push_back(command::join_words({"map", chosen.level}));
  return confirm_if_unsaved(context, "Start a new game anyway?", std::move(started));
}

// Returns a function that draws the player in the chosen colors, into a picture that the function owns. Empty
// if the game has no such picture.
std::function<const formats::Picture*()> make_player_picture(const PageContext& context) {
  const formats::Picture* const plain = context.pictures.find_real("gfx/menuplyr.lmp");
  if (plain == nullptr) return {};
  return [&variables = context.variables, plain, colored = std::make_shared<formats::Picture>()] {
    const int shirt = read_palette_row(variables, kShirt, kShirtRow),
              pants = read_palette_row(variables, kPants, kPantsRow);
    *colored = *plain;
    for (std::uint8_t& pixel : colored->pixels)
      if (pixel / kRowShades == kShirtRow)
        pixel = move_to_row(shirt, pixel);
      else if (pixel / kRowShades == kPantsRow)
        pixel = move_to_row(pants, pixel);
    return colored.get();
  };
}

// Makes sure that the chosen level exists. The first choice is an arena, which games call "dm" and a number,
// or a level with flags if they are to be captured.
void choose_host_level(const PageContext& context) {
  const std::vector<MenuLevel> levels = call_or_default(context.content.levels);
  std::string& chosen = context.choices.host.level;
  const bool needs_flags = context.choices.host.mode == HostMode::kCaptureTheFlag &&
                           std::ranges::any_of(levels, &MenuLevel::has_flags);
  const auto is_chosen = [&](const MenuLevel& level) {
    return level.name == chosen && (level.has_flags || !needs_flags);
  };
  if (levels.empty()) {
    chosen = "start";
  } else if (std::none_of(levels.begin(), levels.end(), is_chosen)) {
    const auto arena = std::ranges::find_if(levels, [&](const MenuLevel& level) {
      return needs_flags ? level.has_flags : level.name.find("dm") != std::string::npos;
    });
    chosen = (arena != levels.end() ? *arena : levels.front()).name;
  }
}

}  // namespace

Page make_multiplayer_page(const PageContext& context) {
  Page page;
  page.title = "Multiplayer";
  page.title_picture = "gfx/p_multi.lmp";
  page.style = PageStyle::kLarge;
  page.rows.push_back(make_page_link(context, "Join", MenuPage::kJoin));
  page.rows.push_back(make_page_link(context, "Host", MenuPage::kHost));
  page.rows.push_back(make_page_link(context, "Player", MenuPage::kPlayer));
  return page;
}

Page make_join_page(const PageContext& context) {
  Page page;
  page.title = "Join";
  page.rows.push_back(make_address_row(context));
  page.rows.push_back(std::make_unique<ActionRow>(
      "Connect", [context] { return connect(context, context.choices.address); },
      "Connects to the address above."));
  if (context.content.search_servers)
    page.rows.push_back(std::make_unique<ActionRow>(
        "Refresh",
        [context] {
          context.content.search_servers();
          return Outcome{.refresh = true};
        },
        "Searches the local network for servers."));
  page.rows.push_back(
      std::make_unique<HeadingRow>("Local network", format_server_columns("level", "players", "ping")));
  const std::vector<MenuServer> servers = call_or_default(context.content.servers);
  for (const MenuServer& server : servers)
    if (!server.address.empty()) page.rows.push_back(make_server_row(context, server));
  if (servers.empty()) page.rows.push_back(std::make_unique<HeadingRow>("No servers found yet."));
  return page;
}

Page make_host_page(const PageContext& context) {
  MenuChoices::Host& chosen = context.choices.host;
  choose_host_level(context);
  Page page;
  page.title = "Host";
  page.rows.push_back(std::make_unique<ActionRow>(
      "Start game", [context] { return start_host_game(context); },
      "Starts the game; others can join at any time."));
  page.rows.push_back(std::make_unique<LevelRow>(chosen.level, find_level_title(context, chosen.level)));
  page.rows.push_back(make_mode_row(chosen));
  page.rows.push_back(make_players_row(chosen));
  if (chosen.mode != HostMode::kCooperative) {
    if (chosen.mode == HostMode::kTeams) page.rows.push_back(make_friendly_fire_row(chosen));
    if (chosen.mode == HostMode::kCaptureTheFlag)
      page.add(make_option_row(
          context.variables,
          {.variable = "capturelimit", .label = "Capture limit", .high = 20, .step = 1, .zero = "none"}));
    else
      page.add(make_option_row(
          context.variables,
          {.variable = "fraglimit", .label = "Frag limit", .high = 100, .step = 5, .zero = "none"}));
    page.add(make_option_row(context.variables, {.variable = "timelimit",
                                                 .label = "Time limit",
                                                 .high = 60,
                                                 .step = 5,
                                                 .unit = " min",
                                                 .zero = "none"}));
    page.add(make_bot_fill_row(context));
    static constexpr std::string_view kBotSkills[] = {"easy", "normal", "hard", "expert"};
    page.add(make_option_row(context.variables,
                             {.variable = "bot_skill", .label = "Bot skill", .names = kBotSkills}));
  } else {
    page.add(make_skill_row(context));
  }
  page.add(make_option_row(context.variables, {.variable = "hostname", .label = "Server name"}));
  page.add(make_port_row(context.variables));
  return page;
}

Page make_player_page(const PageContext& context) {
  Page page;
  page.title = "Player";
  page.empty_text = "No settings here.";
  page.add(make_option_row(context.variables, {.variable = "name", .label = "Name"}));
  page.add(make_color_row(context.variables, {.variable = kShirt, .label = "Shirt color"}));
  page.add(make_color_row(context.variables, {.variable = kPants, .label = "Pants color"}));
  page.picture = make_player_picture(context);
  return page;
}

}  // namespace temblor::client
