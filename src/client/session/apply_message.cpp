// Applies server messages to a ClientState: one overload of Apply::operator() per message type, grouped
// by subject. Every number from a message is checked before it is used as an index.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>

#include "base/text.h"
#include "client/session/client_state.h"

namespace temblor::client {

namespace {

// Limits on what a server can make the client store: a line of commands, and static entities or sounds of a
// level. (Stock Quake allowed 128 static entities.)
constexpr std::size_t kMaxCommandChars = 8192, kMaxStatics = 8192;
// Characters of a wrong line that a message repeats.
constexpr std::size_t kMaxQuotedChars = 80;

// Returns the error for messages that need a level.
base::Status make_too_early_error(const char* what) {
  return base::malformed("{} before a serverinfo: there is no level yet", what);
}

// Fails for entity numbers for which no table has room.
base::Status check_entity(const char* what, int number) {
  if (number < net::kMaxEntities) return base::Ok{};
  return base::malformed("{} of entity {}, expected 0 to {}", what, number, net::kMaxEntities - 1);
}

// Copies the stats that every clientdata message contains. Others arrive as svc_updatestat.
void copy_stats(const net::ClientData& data, std::array<std::int32_t, net::kStats>& io_stats) {
  const auto set = [&](Stat stat, std::int32_t value) { io_stats[static_cast<std::size_t>(stat)] = value; };
  set(Stat::kHealth, data.health);
  set(Stat::kWeaponModel, data.weapon_model);
  set(Stat::kAmmo, data.ammo);
  set(Stat::kArmor, data.armor);
  set(Stat::kWeaponFrame, data.weapon_frame);
  set(Stat::kShells, data.shells);
  set(Stat::kNails, data.nails);
  set(Stat::kRockets, data.rockets);
  set(Stat::kCells, data.cells);
  set(Stat::kActiveWeapon, data.active_weapon);
}

// Precache numbers start at 1; entry 0 stays empty.
std::vector<std::string> make_precache_list(std::span<const std::string_view> names) {
  std::vector<std::string> list = {""};
  list.insert(list.end(), names.begin(), names.end());
  return list;
}

}  // namespace

struct ClientState::Apply {
  ClientState& state;
  Game& game = state.game_;
  Events& events = state.events_;

  // The time of the packet, on the server's clock.
  double now_s() const { return state.window_.end_s; }
  bool has_level() const { return game.models.size() > 1; }

  // Messages that need no action.
  base::Status operator()(const net::Nop&) { return base::Ok{}; }
  base::Status operator()(const net::Disconnect&) { return base::Ok{}; }
  base::Status operator()(const net::Version&) { return base::Ok{}; }
  base::Status operator()(const net::Ignored&) { return base::Ok{}; }

  // The course of the game.

  base::Status operator()(const net::ServerInfo& info) {
    if (info.models.empty()) return base::malformed("serverinfo names no level: its list of models is empty");
    if (info.max_clients == 0) return base::malformed("serverinfo for 0 players, expected at least 1");
    const std::uint32_t turns = game.turns;
    game = {};
    game.turns = turns;
    game.dialect = info.dialect;
    game.deathmatch = info.game_type != 0;
    game.level_name = localize(info.level_name);
    game.models = make_precache_list(info.models);
    game.sounds = make_precache_list(info.sounds);
    game.players.resize(info.max_clients);
    state.previous_time_s_ = 0;
    state.window_ = {};
    state.has_time_ = false;
    state.pings_ = {};
    state.entities_.begin_level();
    state.weapon_.show(0);
    drop_events_of_old_level();
    return base::Ok{};
  }

  // Texts stay, as the player should see them whichever level they came from.
  void drop_events_of_old_level() {
    events.temp_entities.clear();
    events.particles.clear();
    events.damages.clear();
    events.sounds.clear();
    events.stopped_sounds.clear();
    events.static_sounds.clear();
    events.marks.clear();
    events.leak_path.clear();
    events.bonus_flashes = 0;
    events.new_level = true;
  }

  base::Status operator()(const net::SignonNumber& signon) {
    if (signon.number > kPlaying)
      return base::malformed("signon {}, expected 1 to {}", signon.number, kPlaying);
    game.signon = signon.number;
    return base::Ok{};
  }

  base::Status operator()(const net::Time& time) {
    if (!(time.time_s >= 0 && time.time_s <= kMaxServerTime_s))
      return base::malformed("{} s, expected 0 to {}", time.time_s, kMaxServerTime_s);
    const double time_s = static_cast<double>(time.time_s);
    // The first packet of a level has none before it.
    state.previous_time_s_ = state.has_time_ ? now_s() : time_s;
    state.window_ = make_packet_window(state.previous_time_s_, time_s);
    state.has_time_ = true;
    state.entities_.begin_packet();
    return base::Ok{};
  }

  base::Status operator()(const net::SetPause& pause) {
    game.paused = pause.paused;
    return base::Ok{};
  }

  base::Status end_level(Ending ending, std::string_view text) {
    game.ending = ending;
    game.ending_since_s = now_s();
    game.ending_text = localize(text);
    return base::Ok{};
  }
  base::Status operator()(const net::Intermission&) { return end_level(Ending::kIntermission, ""); }
  base::Status operator()(const net::Finale& finale) { return end_level(Ending::kFinale, finale.text); }
  base::Status operator()(const net::CutScene& scene) { return end_level(Ending::kCutScene, scene.text); }

  base::Status operator()(const net::CdTrack& track) {
    game.music_track = track.track;
    return base::Ok{};
  }

  // Texts.

  std::string localize(std::string_view text) const {
    return state.texts_ ? state.texts_->localize_joined(text) : std::string(text);
  }
  // Players choose their names, also such that look like a key. Chat begins with another character.
  bool begins_with_name(std::string_view text) const {
    return std::any_of(game.players.begin(), game.players.end(), [&](const Player& player) {
      return !player.name.empty() && text.starts_with(player.name);
    });
  }

  // A line of the list is "  48 Ranger\n". Returns whether to hide the text.
  bool take_ping(std::string_view text) {
    auto& pings = state.pings_;
    if (text == "Client ping times:\n") {
      pings = {.is_expected = false, .is_reading = true, .is_hidden = pings.is_expected};
      return pings.is_hidden;
    }
    if (!pings.is_reading) return false;
    text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
    int ping_ms = 0;
    const char* const text_end = text.data() + text.size();
    const auto [end, error] = std::from_chars(text.data(), text_end, ping_ms);
    std::string_view name(end, static_cast<std::size_t>(text_end - end));
    pings.is_reading =
        error == std::errc{} && name.starts_with(' ') && name.ends_with('\n') && name.size() > 2;
    if (!pings.is_reading) return false;
    name = name.substr(1, name.size() - 2);
    for (Player& player : game.players)
      if (player.name == name) player.ping_ms = ping_ms;
    return pings.is_hidden;
  }

  base::Status operator()(const net::Print& print) {
    if (take_ping(print.text)) return base::Ok{};
    events.prints.push_back(begins_with_name(print.text) ? std::string(print.text) : localize(print.text));
    return base::Ok{};
  }

  base::Status operator()(const net::BotChat& chat) {
    TRY_STATUS(check_player("chat", chat.client));
    std::vector<std::string> texts;
    for (const std::string_view text : chat.texts) texts.push_back(localize(text));
    if (texts.empty()) return base::Ok{};
    constexpr char kChat = 1;  // the console plays a sound, and draws the text in bronze
    events.prints.push_back(fmt::format("{}{}: {}\n", kChat, game.players[chat.client].name,
                                        formats::fill_places(texts[0], std::span(texts).subspan(1))));
    return base::Ok{};
  }

  base::Status operator()(const net::CenterPrint& print) {
    game.center_text = localize(print.text);
    game.center_text_since_s = now_s();
    return base::Ok{};
  }

  // Collects text to whole lines: a line may arrive in pieces, and a piece may contain several lines. "bf" is
  // the bonus flash; lines that begin with "//" are comments: requests for marks, stats of the game's own,
  // ends of power-ups, combat states, captures, and those with which Temblor servers talk to the Connection.
  base::Status operator()(const net::StuffText& stuffed) {
    for (const char c : stuffed.text) {
      if (c != '\n') {
        // Longer lines are cut.
        if (state.command_line_.size() < kMaxCommandChars) state.command_line_ += c;
        continue;
      }
      if (state.command_line_ == "bf")
        ++events.bonus_flashes;
      else if (net::is_mark_request(state.command_line_))
        add_mark_request(state.command_line_);
      else if (net::is_game_stat(state.command_line_))
        set_game_stat(state.command_line_);
      else if (net::is_powerup_end(state.command_line_))
        set_powerup_end(state.command_line_);
      else if (net::is_combat_state(state.command_line_))
        set_combat_state(state.command_line_);
      else if (net::is_team_captures(state.command_line_))
        set_captures(state.command_line_);
      else if (!state.command_line_.starts_with("//"))
        events.commands.push_back(state.command_line_);
      state.command_line_.clear();
    }
    return base::Ok{};
  }

  void set_game_stat(std::string_view line) {
    base::Result<net::GameStat> stat = net::read_game_stat(line);
    if (!stat.ok()) {
      print_problem(line, stat.error());
    } else if (const auto* whole = std::get_if<std::int32_t>(&stat->value)) {
      game.stats[stat->number] = *whole;
      game.game_stats.erase(stat->number);
    } else {
      game.game_stats[stat->number] = std::move(stat->value);
    }
  }

  void set_powerup_end(std::string_view line) {
    apply_comment(line, net::read_powerup_end(line),
                  [this](const net::PowerupEnd& end) { game.powerup_ends_s[end.bit] = end.end_s; });
  }

  void set_combat_state(std::string_view line) {
    apply_comment(line, net::read_combat_state(line), [this](bool hunted) { game.is_hunted = hunted; });
  }

  void set_captures(std::string_view line) {
    apply_comment(line, net::read_team_captures(line), [this](const net::TeamCaptures& captures) {
      game.captures[captures.color] = captures.count;
    });
  }

  template <typename Value, typename Apply>
  void apply_comment(std::string_view line, const base::Result<Value>& read, const Apply& apply) {
    if (read.ok())
      apply(*read);
    else
      print_problem(line, read.error());
  }

  // Errors reach the console, as they help the author of the game code.
  void print_problem(std::string_view line, const base::Error& error) {
    events.prints.push_back(
        fmt::format("\"{}\": {}\n", base::quotable(line, kMaxQuotedChars), error.message()));
  }

  void add_mark_request(std::string_view line) {
    base::Result<net::MarkRequest> request = net::read_mark_request(line);
    if (request.ok())
      events.marks.push_back(std::move(request).value());
    else
      print_problem(line, request.error());
  }

  // The original's shareware version opened its help pages.
  base::Status operator()(const net::SellScreen&) {
    events.commands.emplace_back("help");
    return base::Ok{};
  }

  // The player.

  base::Status operator()(const net::ClientData& data) {
    if (!has_level()) return make_too_early_error("clientdata");
    // A new weapon appears without blending from the old one's frame.
    if (data.weapon_model == game.data.weapon_model)
      state.weapon_.update(data.weapon_frame, state.window_.begin_s, kThinkInterval_s);
    else
      state.weapon_.show(data.weapon_frame);
    game.data = data;
    copy_stats(data, game.stats);
    return base::Ok{};
  }

  base::Status operator()(const net::UpdateStat& update) {
    game.stats[update.stat] = update.value;
    game.game_stats.erase(update.stat);
    return base::Ok{};
  }
  base::Status count(Stat stat) {
    std::int32_t& value = game.stats[static_cast<std::size_t>(stat)];
    if (value < std::numeric_limits<std::int32_t>::max()) ++value;
    return base::Ok{};
  }
  base::Status operator()(const net::KilledMonster&) { return count(Stat::kMonsters); }
  base::Status operator()(const net::FoundSecret&) { return count(Stat::kSecrets); }

  base::Status operator()(const net::SetView& view) {
    TRY_STATUS(check_entity("setview", view.entity));
    game.view_entity = view.entity;
    return base::Ok{};
  }
  base::Status operator()(const net::SetAngle& angle) {
    game.set_angles_deg = angle.angles_deg;
    ++game.turns;
    return base::Ok{};
  }
  base::Status operator()(const net::Damage& damage) {
    events.damages.push_back(damage);
    game.last_damage_s = now_s();
    return base::Ok{};
  }
  base::Status operator()(const net::BonusFlash&) {
    ++events.bonus_flashes;
    return base::Ok{};
  }

  // All players.

  base::Status check_player(const char* what, std::size_t slot) const {
    if (slot < game.players.size()) return base::Ok{};
    return base::malformed("{} of player slot {}, but the server has {}", what, slot, game.players.size());
  }
  base::Status operator()(const net::UpdateName& update) {
    TRY_STATUS(check_player("name", update.client));
    game.players[update.client].name = update.name;
    return base::Ok{};
  }
  base::Status operator()(const net::UpdateFrags& update) {
    TRY_STATUS(check_player("frags", update.client));
    game.players[update.client].frags = update.frags;
    return base::Ok{};
  }
  base::Status operator()(const net::UpdateColors& update) {
    TRY_STATUS(check_player("colors", update.client));
    game.players[update.client].shirt = static_cast<std::uint8_t>(update.colors >> 4);
    game.players[update.client].pants = update.colors & 15;
    return base::Ok{};
  }

  // Entities.

  base::Status operator()(const net::SpawnBaseline& baseline) {
    if (!has_level()) return make_too_early_error("a baseline");
    TRY_STATUS(check_entity("baseline", baseline.number));
    state.entities_.set_baseline(baseline.number, baseline.entity);
    return base::Ok{};
  }
  base::Status operator()(const net::SpawnStatic& spawned) {
    if (!has_level()) return make_too_early_error("a static entity");
    if (state.entities_.static_count() >= kMaxStatics)
      return base::error(base::ErrorCode::kTooLarge, "more than {} static entities", kMaxStatics);
    state.entities_.add_static(spawned.entity);
    return base::Ok{};
  }
  base::Status operator()(const net::EntityUpdate& update) {
    if (!has_level()) return make_too_early_error("an entity update");
    TRY_STATUS(check_entity("update", update.number));
    // No message announces the last stage of the signon: the first update does.
    if (game.signon == kPlaying - 1) game.signon = kPlaying;
    state.entities_.update(update, state.window_);
    // The view entity's muzzle flash is that of the weapon in hand.
    const bool flashes = (update.effects.value_or(std::uint8_t{0}) & kEffectMuzzleFlash) != 0;
    if (flashes && update.number == game.view_entity) state.weapon_.flash();
    return base::Ok{};
  }

  // The level.

  base::Status operator()(const net::LightStyle& style) {
    if (style.style >= world::kLightStyles)
      return base::malformed("light style {}, expected 0 to {}", style.style, world::kLightStyles - 1);
    game.light_styles[style.style] = style.pattern;
    return base::Ok{};
  }
  base::Status operator()(const net::Skybox& skybox) {
    game.skybox = skybox.name;
    return base::Ok{};
  }
  base::Status operator()(const net::Fog& fog) {
    game.fog_before = compute_fog_mixture(game, now_s());
    game.fog = fog;
    game.fog_since_s = now_s();
    return base::Ok{};
  }

  // Events, which happen once.

  base::Status operator()(const net::TempEntity& entity) {
    events.temp_entities.push_back(entity);
    return base::Ok{};
  }
  base::Status operator()(const net::Particles& particles) {
    events.particles.push_back(particles);
    return base::Ok{};
  }
  base::Status operator()(const net::Sound& sound) {
    events.sounds.push_back(sound);
    return base::Ok{};
  }
  base::Status operator()(const net::StopSound& sound) {
    events.stopped_sounds.push_back(sound);
    return base::Ok{};
  }
  base::Status operator()(const net::SpawnStaticSound& sound) {
    if (events.static_sounds.size() < kMaxStatics) events.static_sounds.push_back(sound);
    return base::Ok{};
  }
};

base::Status ClientState::apply(const net::ServerMessage& message) {
  return std::visit(Apply{*this}, message);
}

}  // namespace temblor::client
