// Built-in functions that name the models, sounds and files of a level before it starts. A name's number is
// its place in the list, and clients get the lists when they join, so nothing can be added later.
#include <algorithm>

#include "base/text.h"
#include "server/builtins/families.h"

namespace temblor::server {
namespace {

// The largest number of a name. Numbers start at 1. Protocol 15 has one byte for them.
std::size_t max_number(Call& io_call, int extended_count) {
  const bool is_stock = io_call.game.outbox.dialect().protocol == net::Protocol::kNetQuake;
  return is_stock ? 255 : static_cast<std::size_t>(extended_count) - 1;
}

base::Status check_name(Call& io_call, std::string_view name) {
  if (!io_call.game.precache.is_open)
    return io_call.error("\"{}\" is precached too late: only spawn functions may precache",
                         base::quotable(name));
  if (name.empty() || name.front() <= ' ')
    return io_call.error("\"{}\" is not a file name", base::quotable(name));
  return base::Ok{};
}

base::Status check_room(Call& io_call, std::string_view name, std::size_t count, std::size_t max) {
  if (count <= max) return base::Ok{};
  return io_call.error("\"{}\" is one too many: protocol {} allows {}", base::quotable(name),
                       static_cast<int>(io_call.game.outbox.dialect().protocol), max);
}

// All precache functions return the name. This one does nothing else: files that are not models or sounds are
// loaded when they are used.
base::Status precache_file(Call& io_call) {
  io_call.machine.return_string(io_call.machine.parameter_string(0));
  return base::Ok{};
}

// A sound need not exist: only clients load it.
base::Status precache_sound(Call& io_call) {
  const std::string_view name = io_call.text(0);
  TRY_STATUS(check_name(io_call, name));
  std::vector<std::string>& sounds = io_call.game.precache.sounds;
  if (std::find(sounds.begin(), sounds.end(), name) == sounds.end()) {
    TRY_STATUS(check_room(io_call, name, sounds.size(), max_number(io_call, net::kMaxSounds)));
    sounds.emplace_back(name);
  }
  return precache_file(io_call);
}

// Replaces a missing or damaged file. The level continues, and clients show a placeholder, too.
ServerModel placeholder() {
  return {"", {math::Vec3{-16.0f}, math::Vec3{16.0f}}};
}

base::Status precache_model(Call& io_call) {
  const std::string_view name = io_call.text(0);
  TRY_STATUS(check_name(io_call, name));
  std::vector<ServerModel>& models = io_call.world.models;
  const bool is_known =
      std::any_of(models.begin(), models.end(), [&](const ServerModel& model) { return model.name == name; });
  if (!is_known) {
    TRY_STATUS(check_room(io_call, name, models.size(), max_number(io_call, net::kMaxModels)));
    if (!io_call.game.load_model) return io_call.error("\"{}\": there are no files", base::quotable(name));
    base::Result<ServerModel> model = io_call.game.load_model(name);
    if (!model.ok()) io_call.warn_once(fmt::format("{}{}", model.error().message(), io_call.call_site()));
    models.push_back(model.ok() ? *std::move(model) : placeholder());
    models.back().name = name;  // setmodel() looks for this name
  }
  return precache_file(io_call);
}

}  // namespace

// The variants with a 2 do the same: in the original, they marked files that the packer left out of the
// shareware version.
std::span<const BuiltinEntry> precache_builtins() {
  static constexpr BuiltinEntry kEntries[] = {
      {19, "precache_sound", precache_sound},  {20, "precache_model", precache_model},
      {68, "precache_file", precache_file},    {75, "precache_model2", precache_model},
      {76, "precache_sound2", precache_sound}, {77, "precache_file2", precache_file},
  };
  return kEntries;
}

}  // namespace temblor::server
