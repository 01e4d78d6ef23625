// Playing with others: joining, hosting, and what the player is called and wears.
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
constexpr int kDeathmatch = 0;

// Rows of the palette that a player's clothes are drawn in.
constexpr int kRowShades = 16, kShirtRow = 1, kPantsRow = 6;

constexpr std::string_view kShirt = "topcolor", kPants = "bottomcolor";

int row_of(const command::Variables& variables, std::string_view name, int otherwise) {
  const command::Variable* const color = variables.find(name);
  return color == nullptr ? otherwise : static_cast<int>(color->number) & 15;
}

// The same shade of another row. From the eighth on they run from bright to dark.
std::uint8_t in_row(int row, std::uint8_t pixel) {
  constexpr int kFirstReversed = 8;
  const int shade = pixel % kRowShades;
  return static_cast<std::uint8_t>(row * kRowShades +
                                   (row < kFirstReversed ? shade : kRowShades - 1 - shade));
}

Outcome connect(const PageContext& context, const std::string& address) {
  if (address.empty()) return {};
  return unless_lost(context, "Connect all the same?",
                     {.commands = {command::join_words({"connect", address})}, .leaving = Leaving::kClose});
}

std::unique_ptr<Row> make_address_row(const PageContext& context) {
  return std::make_unique<TextRow>(
      "Address",
      TextRow::Parts{.read = [context] { return context.choices.address; },
                     .write =
                         [context](std::string address) {
                           context.choices.address = address;
                           return connect(context, address);
                         },
                     .help = "Of a server: a name or number, a colon and a port behind it if need be.",
                     .clipboard = context.content.clipboard});
}

std::string server_columns(std::string_view level, std::string_view players, std::string_view ping) {
  constexpr std::size_t kLevel = 8, kNumber = 5;
  const auto spaces = [](std::size_t most, const std::string& text) {
    return std::string(most - text.size(), ' ');
  };
  const std::string first = cut(level, kLevel), second = cut(players, kNumber), third = cut(ping, kNumber);
  return first + spaces(kLevel, first) + ' ' + spaces(kNumber, second) + second + ' ' +
         spaces(kNumber, third) + third;
}

std::unique_ptr<Row> make_server_row(const PageContext& context, const MenuServer& server) {
  return std::make_unique<ListRow>(ListEntry{
      .left = server.name.empty() ? server.address : server.name,
      .right = server_columns(server.level, fmt::format("{}/{}", server.players, server.max_players),
                              fmt::format("{}ms", server.ping_ms)),
      .choose = [context, address = server.address] { return connect(context, address); },
      .help = fmt::format("{}: {}", server.address, server.name)});
}

std::string title_of(const PageContext& context, const std::string& level) {
  for (const MenuLevel& found : asked(context.content.levels))
    if (found.name == level && !found.title.empty()) return found.title;
  return level;
}

// A list of levels that goes back to the page of hosting.
Page make_host_level_page(const PageContext& context) {
  Page page;
  page.title = "Level";
  page.style = PageStyle::kDetails;
  page.searched = true;
  page.nothing = "No levels were found.";
  for (const MenuLevel& level : asked(context.content.levels)) {
    if (level.name.empty()) continue;
    if (level.name == context.choices.host.level) page.first_choice = page.rows.size();
    page.rows.push_back(make_level_row(context.content, level, [context, name = level.name] {
      context.choices.host.level = name;
      return Outcome{.leaving = Leaving::kBack};
    }));
  }
  return page;
}

class LevelRow : public ActionRow {
 public:
  LevelRow(const std::string& name, const std::string& title)
      : ActionRow(
            "Level", [] { return Outcome{.page = make_host_level_page}; },
            fmt::format("{}: {}. Enter: a list of levels.", name, title)),
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
  parts.help = "How many may play, you among them.";
  return std::make_unique<LocalChoiceRow>("Players", std::move(parts));
}

std::unique_ptr<Row> make_mode_row(MenuChoices::Host& io_host) {
  LocalChoiceRow::Parts parts;
  parts.names = {"deathmatch", "coop"};
  parts.chosen = [&io_host] { return io_host.mode; };
  parts.choose = [&io_host](int number) { io_host.mode = number; };
  parts.help = "Players against one another, or together.";
  parts.refresh = true;
  return std::make_unique<LocalChoiceRow>("Game", std::move(parts));
}

// A number that is typed: a slider for all of them would be no use.
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

Outcome host(const PageContext& context) {
  const MenuChoices::Host& chosen = context.choices.host;
  const bool deathmatch = chosen.mode == kDeathmatch;
  Outcome begun{.leaving = Leaving::kClose};
  begun.commands = {"disconnect", fmt::format("maxplayers {}", chosen.players),
                    fmt::format("deathmatch {}", deathmatch ? 1 : 0),
                    fmt::format("coop {}", deathmatch ? 0 : 1)};
  begun.commands.push_back(command::join_words({"map", chosen.level}));
  return unless_lost(context, "Begin another one all the same?", std::move(begun));
}

// The player in his colors, in a picture that the function keeps; empty where the game has none.
std::function<const formats::Picture*()> figure_in_colors(const PageContext& context) {
  const formats::Picture* const plain = context.pictures.find_real("gfx/menuplyr.lmp");
  if (plain == nullptr) return {};
  return [&variables = context.variables, plain, dressed = std::make_shared<formats::Picture>()] {
    const int shirt = row_of(variables, kShirt, kShirtRow), pants = row_of(variables, kPants, kPantsRow);
    *dressed = *plain;
    for (std::uint8_t& pixel : dressed->pixels)
      if (pixel / kRowShades == kShirtRow)
        pixel = in_row(shirt, pixel);
      else if (pixel / kRowShades == kPantsRow)
        pixel = in_row(pants, pixel);
    return dressed.get();
  };
}

// The level that is chosen must be one that there is; at first an arena, which games name "dm" and a number.
void choose_host_level(const PageContext& context) {
  const std::vector<MenuLevel> levels = asked(context.content.levels);
  std::string& chosen = context.choices.host.level;
  const auto is_chosen = [&](const MenuLevel& level) { return level.name == chosen; };
  if (levels.empty()) {
    chosen = "start";
  } else if (std::none_of(levels.begin(), levels.end(), is_chosen)) {
    const auto arena = std::ranges::find_if(
        levels, [](const MenuLevel& level) { return level.name.find("dm") != std::string::npos; });
    chosen = (arena != levels.end() ? *arena : levels.front()).name;
  }
}

}  // namespace

Page make_multiplayer_page(const PageContext& context) {
  Page page;
  page.title = "Multiplayer";
  page.title_picture = "gfx/p_multi.lmp";
  page.style = PageStyle::kLarge;
  page.rows.push_back(make_opener(context, "Join", MenuPage::kJoin));
  page.rows.push_back(make_opener(context, "Host", MenuPage::kHost));
  page.rows.push_back(make_opener(context, "Player", MenuPage::kPlayer));
  return page;
}

Page make_join_page(const PageContext& context) {
  Page page;
  page.title = "Join";
  page.rows.push_back(make_address_row(context));
  page.rows.push_back(std::make_unique<ActionRow>(
      "Connect", [context] { return connect(context, context.choices.address); },
      "To the server of the address above."));
  if (context.content.search_servers)
    page.rows.push_back(std::make_unique<ActionRow>(
        "Search again",
        [context] {
          context.content.search_servers();
          return Outcome{.refresh = true};
        },
        "Asks the local network who is there."));
  page.rows.push_back(
      std::make_unique<HeadingRow>("Local network", server_columns("level", "users", "ping")));
  const std::vector<MenuServer> servers = asked(context.content.servers);
  for (const MenuServer& server : servers)
    if (!server.address.empty()) page.rows.push_back(make_server_row(context, server));
  if (servers.empty()) page.rows.push_back(std::make_unique<HeadingRow>("None has answered yet."));
  return page;
}

Page make_host_page(const PageContext& context) {
  MenuChoices::Host& chosen = context.choices.host;
  choose_host_level(context);
  Page page;
  page.title = "Host";
  page.rows.push_back(std::make_unique<ActionRow>(
      "Begin", [context] { return host(context); }, "Begins the game and waits for others."));
  page.rows.push_back(std::make_unique<LevelRow>(chosen.level, title_of(context, chosen.level)));
  page.rows.push_back(make_mode_row(chosen));
  page.rows.push_back(make_players_row(chosen));
  if (chosen.mode == kDeathmatch) {
    static constexpr std::string_view kTeams[] = {"off", "no friendly fire", "friendly fire"};
    page.add(make_option_row(
        context.variables,
        {.variable = "fraglimit", .label = "Frag limit", .high = 100, .step = 5, .zero = "none"}));
    page.add(make_option_row(context.variables, {.variable = "timelimit",
                                                 .label = "Time limit",
                                                 .high = 60,
                                                 .step = 5,
                                                 .unit = "min",
                                                 .zero = "none"}));
    page.add(make_option_row(context.variables, {.variable = "teamplay", .label = "Teams", .names = kTeams}));
    page.add(make_option_row(
        context.variables,
        {.variable = "bot_fill", .label = "Bots fill up to", .high = 8, .step = 1, .zero = "none"}));
    static constexpr std::string_view kBotSkills[] = {"beginners", "fair", "good", "hard"};
    page.add(make_option_row(context.variables,
                             {.variable = "bot_skill", .label = "Bots' skill", .names = kBotSkills}));
  } else {
    page.add(make_skill_row(context));
  }
  page.add(make_option_row(context.variables, {.variable = "hostname", .label = "Server's name"}));
  page.add(make_port_row(context.variables));
  return page;
}

Page make_player_page(const PageContext& context) {
  Page page;
  page.title = "Player";
  page.nothing = "There is nothing to set.";
  page.add(make_option_row(context.variables, {.variable = "name", .label = "Name"}));
  page.add(make_color_row(context.variables, {.variable = kShirt, .label = "Shirt"}));
  page.add(make_color_row(context.variables, {.variable = kPants, .label = "Pants"}));
  page.picture = figure_in_colors(context);
  return page;
}

}  // namespace temblor::client
