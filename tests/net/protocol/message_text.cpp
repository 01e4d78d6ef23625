#include "net/protocol/message_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <optional>
#include <variant>

namespace temblor::test {
namespace {

using namespace net;

std::string text(const math::Vec3& v) {
  return fmt::format("({} {} {})", v.x, v.y, v.z);
}
template <typename T>
std::string text(const std::optional<T>& value) {
  return value ? fmt::format("{}", *value) : "-";
}
std::string text(const Baseline& b) {
  return fmt::format("model {} frame {} colormap {} skin {} origin {} angles {} alpha {} scale {}", b.model,
                     b.frame, b.colormap, b.skin, text(b.origin), text(b.angles_deg), b.alpha, b.scale);
}
std::string text(const std::array<std::optional<float>, 3>& values) {
  return fmt::format("({} {} {})", text(values[0]), text(values[1]), text(values[2]));
}

struct Fields {
  // Messages without fields.
  template <typename Message>
  std::string operator()(const Message&) const {
    static_assert(std::is_empty_v<Message>);
    return "";
  }
  std::string operator()(const UpdateStat& m) const { return fmt::format("{} {}", m.stat, m.value); }
  std::string operator()(const Version& m) const { return fmt::format("{}", m.version); }
  std::string operator()(const SetView& m) const { return fmt::format("{}", m.entity); }
  std::string operator()(const Sound& m) const {
    return fmt::format("volume {} attenuation {} entity {} channel {} sound {} origin {}", m.volume,
                       m.attenuation, m.entity, m.channel, m.sound, text(m.origin));
  }
  std::string operator()(const Time& m) const { return fmt::format("{}", m.time_s); }
  std::string operator()(const Print& m) const { return std::string(m.text); }
  std::string operator()(const StuffText& m) const { return std::string(m.text); }
  std::string operator()(const CenterPrint& m) const { return std::string(m.text); }
  std::string operator()(const Finale& m) const { return std::string(m.text); }
  std::string operator()(const CutScene& m) const { return std::string(m.text); }
  std::string operator()(const Skybox& m) const { return std::string(m.name); }
  std::string operator()(const SetAngle& m) const { return text(m.angles_deg); }
  std::string operator()(const ServerInfo& m) const {
    return fmt::format("protocol {} flags {} clients {} game {} level {} models {} sounds {}",
                       static_cast<int>(m.dialect.protocol), m.dialect.flags, m.max_clients, m.game_type,
                       m.level_name, m.models, m.sounds);
  }
  std::string operator()(const LightStyle& m) const { return fmt::format("{} {}", m.style, m.pattern); }
  std::string operator()(const UpdateName& m) const { return fmt::format("{} {}", m.client, m.name); }
  std::string operator()(const UpdateFrags& m) const { return fmt::format("{} {}", m.client, m.frags); }
  std::string operator()(const UpdateColors& m) const { return fmt::format("{} {}", m.client, m.colors); }
  std::string operator()(const ClientData& m) const {
    return fmt::format(
        "view height {} ideal pitch {} punch {} velocity {} items {:#x} on ground {} in water {} weapon "
        "frame "
        "{} armor {} weapon model {} health {} ammo {} of {} {} {} {} active weapon {} weapon alpha {}",
        m.view_height, m.ideal_pitch_deg, text(m.punch_deg), text(m.velocity), m.items, m.on_ground,
        m.in_water, m.weapon_frame, m.armor, m.weapon_model, m.health, m.ammo, m.shells, m.nails, m.rockets,
        m.cells, m.active_weapon, m.weapon_alpha);
  }
  std::string operator()(const StopSound& m) const { return fmt::format("{} {}", m.entity, m.channel); }
  std::string operator()(const Particles& m) const {
    return fmt::format("origin {} direction {} count {} color {}", text(m.origin), text(m.direction), m.count,
                       m.color);
  }
  std::string operator()(const Damage& m) const {
    return fmt::format("armor {} blood {} from {}", m.armor, m.blood, text(m.from));
  }
  std::string operator()(const SpawnStatic& m) const { return text(m.entity); }
  std::string operator()(const SpawnBaseline& m) const {
    return fmt::format("{} {}", m.number, text(m.entity));
  }
  std::string operator()(const EntityUpdate& m) const {
    return fmt::format(
        "{} model {} frame {} colormap {} skin {} effects {} origin {} angles {} alpha {} scale {} next "
        "think "
        "{} step {}",
        m.number, text(m.model), text(m.frame), text(m.colormap), text(m.skin), text(m.effects),
        text(m.origin), text(m.angles_deg), text(m.alpha), text(m.scale), text(m.next_think_s), m.step);
  }
  std::string operator()(const TempEntity& m) const {
    return fmt::format("kind {} origin {} end {} entity {} colors {} {}", static_cast<int>(m.kind),
                       text(m.origin), text(m.end), m.entity, m.color_start, m.color_count);
  }
  std::string operator()(const SetPause& m) const { return fmt::format("{}", m.paused); }
  std::string operator()(const SignonNumber& m) const { return fmt::format("{}", m.number); }
  std::string operator()(const SpawnStaticSound& m) const {
    return fmt::format("origin {} sound {} volume {} attenuation {}", text(m.origin), m.sound, m.volume,
                       m.attenuation);
  }
  std::string operator()(const CdTrack& m) const { return fmt::format("{} {}", m.track, m.loop_track); }
  std::string operator()(const Fog& m) const {
    return fmt::format("density {} color {} fade {}", m.density, text(m.color), m.fade_s);
  }
  std::string operator()(const BotChat& m) const { return fmt::format("{} {}", m.client, m.texts); }
  std::string operator()(const Ignored& m) const { return fmt::format("{}", m.id); }
};

}  // namespace

std::string get_text(const net::ServerMessage& message) {
  return fmt::format("{}: {}", message_name(message), std::visit(Fields{}, message));
}

}  // namespace temblor::test
