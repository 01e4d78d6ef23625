#include "host/commands/sound_commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>

#include "base/text.h"
#include "command/text.h"
#include "host/commands/command_adder.h"
#include "host/commands/shown_state.h"
#include "host/frame/host_parts.h"

namespace temblor::host {
namespace {

using Arguments = command::Console::Arguments;

client::AudioScene& audio_scene(Host& io_host) {
  return io_host.game.data->presentation.audio_scene();
}

void play(Host& io_host, Arguments arguments) {
  if (arguments.size() < 2)
    return io_host.console.commands.print_error("play FILE...: name a sound, for example misc/menu1.wav");
  for (const std::string& name : arguments.subspan(1)) audio_scene(io_host).play_local(name);
}

void play_at_volume(Host& io_host, Arguments arguments) {
  constexpr std::string_view kUsage = "playvol FILE VOLUME [FILE VOLUME]...: volumes are 0 to 1";
  if (arguments.size() < 3 || arguments.size() % 2 == 0) return io_host.console.commands.print_error(kUsage);
  for (std::size_t i = 1; i + 1 < arguments.size(); i += 2) {
    const std::optional<double> volume = command::parse_number(arguments[i + 1]);
    if (!volume) return io_host.console.commands.print_error(kUsage);
    audio_scene(io_host).play_local(arguments[i], static_cast<float>(std::clamp(*volume, 0.0, 1.0)));
  }
}

void list_sounds(Host& io_host, Arguments arguments) {
  const client::ClientState* const state = find_shown_state(io_host, arguments);
  if (state == nullptr) return;
  const std::vector<std::string>& names = state->game().sounds;
  for (std::size_t i = 1; i < names.size(); ++i) print_line(io_host, fmt::format("{:4}: {}", i, names[i]));
  print_line(io_host, base::counted(std::max<std::size_t>(names.size(), 1) - 1, "sound"));
}

// The track of a level is the server's, so another one is played as if the server had named it.
void play_track(Host& io_host, Arguments arguments, std::uint8_t track) {
  client::ClientState* const state = find_shown_state(io_host, arguments);
  if (state == nullptr) return;
  io_host.sound.is_music_paused = false;
  apply_message(io_host, *state, net::CdTrack{track, track});
}

// "5", "05", "track05", or "music/track05.ogg".
std::optional<std::uint8_t> parse_track(std::string_view name) {
  constexpr std::string_view kFolder = "music/", kTrack = "track";
  if (name.starts_with(kFolder)) name.remove_prefix(kFolder.size());
  name = name.substr(0, name.rfind('.'));
  if (name.starts_with(kTrack)) name.remove_prefix(kTrack.size());
  const std::optional<std::int64_t> number = command::parse_whole_number(name);
  return number && *number >= 0 && *number <= 255 ? std::optional(static_cast<std::uint8_t>(*number))
                                                  : std::nullopt;
}

void play_music(Host& io_host, Arguments arguments) {
  const std::optional<std::uint8_t> track = arguments.size() == 2 ? parse_track(arguments[1]) : std::nullopt;
  if (!track) return io_host.console.commands.print_error("music TRACK: a number, or the name of its file");
  play_track(io_host, arguments, *track);
}

void cd_command(Host& io_host, Arguments arguments) {
  const std::string action = arguments.size() > 1 ? base::to_lower(arguments[1]) : "";
  if (action == "stop" || action == "off") return play_track(io_host, arguments, 0);
  if (action == "pause" || action == "resume" || action == "on") {
    io_host.sound.is_music_paused = action == "pause";
    return;
  }
  if ((action == "play" || action == "loop") && arguments.size() > 2)
    if (const std::optional<std::uint8_t> track = parse_track(arguments[2]))
      return play_track(io_host, arguments, *track);
  // Drives have more actions (eject, close, remap), which have no meaning for files.
  if (action.empty() || action == "play" || action == "loop")
    io_host.console.commands.print_error("cd play TRACK, cd loop TRACK, cd stop, cd pause, or cd resume");
}

}  // namespace

void add_sound_commands(Host& io_host) {
  const auto add = make_adder(io_host);
  add("play", "play FILE...: plays sounds, for example misc/menu1.wav.", play);
  add("playvol", "playvol FILE VOLUME...: plays sounds at these volumes, 0 to 1.", play_at_volume);
  add("stopsound", "Stops all sounds.",
      [](Host& host, Arguments) { audio_scene(host).events().stops_all = true; });
  add("soundlist", "Lists the sounds of this level.", list_sounds);
  add("soundinfo", "Describes the sound device.", [](Host& host, Arguments) {
    print_line(host, host.sound.output ? host.sound.output->describe() : "sound is off");
  });
  add("music", "music TRACK: plays music/trackNN.", play_music);
  add("music_stop", "Stops the music.",
      [](Host& host, Arguments arguments) { play_track(host, arguments, 0); });
  add("music_pause", "Pauses the music.", [](Host& host, Arguments) { host.sound.is_music_paused = true; });
  add("music_resume", "Resumes the music.",
      [](Host& host, Arguments) { host.sound.is_music_paused = false; });
  add("cd", "cd play TRACK, cd stop, cd pause, or cd resume: controls the music.", cd_command);
}

}  // namespace temblor::host
