#include "scripted_player/film/film_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "base/check.h"
#include "net/protocol/message_reader.h"
#include "net/protocol/message_writer.h"

namespace temblor::player {
namespace {

constexpr std::string_view kCameraModel = "progs/player.mdl";
// Between the last record before a cut and the first after it.
constexpr float kCut_s = 1.0f / 72;

template <typename... Types>
bool holds_any(const net::ServerMessage& message) {
  return (std::holds_alternative<Types>(message) || ...);
}

// The additional entities of a scene.
struct FilmEntities {
  std::uint16_t camera = 0, title = 0;              // entity numbers
  std::uint16_t camera_model = 0, title_model = 0;  // in the level's list; 0: none
};

// Calls `use` with each message of each record, and with the record.
template <typename Use>
base::Status for_each_message(base::Bytes demo, const Use& use) {
  TRY(formats::DemReader records, formats::DemReader::open(demo));
  net::MessageReader messages;
  while (true) {
    TRY(const std::optional<formats::DemMessage> record, records.next());
    if (!record) return base::Ok{};
    messages.begin(record->message, record->offset);
    while (true) {
      TRY(const std::optional<net::ServerMessage> message, messages.next());
      if (!message) break;
      TRY_STATUS(use(*record, *message));
    }
  }
}

// Chooses entity numbers above all of the demo.
base::Result<FilmEntities> choose_entities(base::Bytes demo) {
  FilmEntities entities;
  int last = 0;
  TRY_STATUS(for_each_message(demo, [&](const formats::DemMessage&, const net::ServerMessage& message) {
    if (const auto* update = std::get_if<net::EntityUpdate>(&message))
      last = std::max<int>(last, update->number);
    if (const auto* base = std::get_if<net::SpawnBaseline>(&message))
      last = std::max<int>(last, base->number);
    return base::Status(base::Ok{});
  }));
  entities.camera = static_cast<std::uint16_t>(last + 1);
  entities.title = static_cast<std::uint16_t>(last + 2);
  return entities;
}

net::EntityUpdate make_update(std::uint16_t number, std::uint16_t model, const math::Vec3& origin,
                              const math::Vec3& angles_deg) {
  return {.number = number,
          .model = model,
          .origin = {origin.x, origin.y, origin.z},
          .angles_deg = {angles_deg.x, angles_deg.y, angles_deg.z}};
}

// One scene on its way from demo to film.
class SceneCutter {
 public:
  SceneCutter(const FilmScript& script, const FilmScene& scene, const CameraPoses& poses,
              const FilmEntities& entities, formats::DemWriter& io_writer)
      : script_(script), scene_(scene), poses_(poses), entities_(entities), io_writer_(io_writer) {}

  base::Status cut(base::Bytes demo) {
    base::Status status = for_each_message(
        demo, [&](const formats::DemMessage& record, const net::ServerMessage& message) -> base::Status {
          if (record.offset != record_offset_) TRY_STATUS(finish_record());
          record_offset_ = record.offset;
          angles_deg_ = record.view_angles_deg;
          return add(message);
        });
    TRY_STATUS(std::move(status));
    return finish_record();
  }

 private:
  base::Status write(const net::ServerMessage& message) {
    return net::write_message(message, dialect_, record_);
  }

  base::Status add(const net::ServerMessage& message) {
    if (const auto* info = std::get_if<net::ServerInfo>(&message)) return begin_level(*info);
    if (const auto* time = std::get_if<net::Time>(&message)) return begin_tick(time->time_s);
    if (std::holds_alternative<net::EntityUpdate>(message)) is_playing_ = true;
    if (std::holds_alternative<net::CdTrack>(message))
      return write(net::CdTrack{script_.track, script_.track});
    return is_kept(message) ? write(message) : base::Status(base::Ok{});
  }

  bool is_kept(const net::ServerMessage& message) const {
    // The end of the demo is not that of the film. The game's own ending and its texts would cover the view.
    if (holds_any<net::Disconnect, net::Intermission, net::Finale, net::CutScene, net::CenterPrint>(message))
      return false;
    if (!is_playing_) return true;
    if (shot_ == nullptr)
      return holds_any<net::UpdateStat, net::LightStyle, net::UpdateName, net::UpdateFrags, net::UpdateColors,
                       net::SpawnStatic, net::SpawnStaticSound, net::Skybox, net::Fog>(message);
    return !shot_->is_flight() ||
           !holds_any<net::Damage, net::BonusFlash, net::StuffText, net::Print, net::SetAngle>(message);
  }

  base::Status begin_level(const net::ServerInfo& info) {
    net::ServerInfo changed = info;
    // Angles of entities need more than a byte for smooth flights.
    changed.dialect = {net::Protocol::kRmq, info.dialect.flags | net::kShortAngle};
    dialect_ = changed.dialect;
    std::vector<std::string_view> models(info.models.begin(), info.models.end());
    const auto found = std::find(models.begin(), models.end(), kCameraModel);
    if (found == models.end())
      return base::malformed("{}: the level does not use {}", scene_.map, kCameraModel);
    entities_.camera_model = static_cast<std::uint16_t>(found - models.begin() + 1);
    if (!script_.title_model.empty()) {
      models.push_back(script_.title_model);
      entities_.title_model = static_cast<std::uint16_t>(models.size());
    }
    changed.models = models;
    return write(changed);
  }

  // Every record with entities begins with the time.
  base::Status begin_tick(float time_s) {
    tick_s_ = time_s;
    shot_ = nullptr;
    for (const Shot& shot : scene_.shots)
      if (double{time_s} >= shot.begin_s && double{time_s} < shot.end_s) shot_ = &shot;
    if (shot_ == nullptr && is_playing_) return base::Ok{};
    if (shot_ != last_shot_ && shot_ != nullptr) {
      moved_s_ = time_s - (film_s_ + kCut_s);
      last_shot_ = shot_;
    }
    film_s_ = time_s - moved_s_;
    return write(net::Time{film_s_});
  }

  // Appends the camera, and writes the record.
  base::Status finish_record() {
    if (record_.size() == 0) return base::Ok{};
    if (shot_ != nullptr && shot_->is_flight() && is_playing_) {
      const auto pose = poses_.lower_bound(tick_s_ - kCut_s / 2);
      if (pose != poses_.end() && pose->first < tick_s_ + kCut_s / 2) TRY_STATUS(add_camera(pose->second));
    }
    if (record_.size() > formats::kMaxStockDemMessage)
      return base::malformed("{}: a tick has {} bytes, at most {} are allowed", scene_.map, record_.size(),
                             formats::kMaxStockDemMessage);
    io_writer_.add(angles_deg_, record_.view());
    record_.truncate(0);
    return base::Ok{};
  }

  base::Status add_camera(const CameraPose& pose) {
    if (!has_camera_) {
      TRY_STATUS(write(net::SetView{entities_.camera}));
      TRY_STATUS(write(net::CutScene{""}));
      has_camera_ = true;
    }
    angles_deg_ = pose.angles_deg;
    if (shot_->title)
      TRY_STATUS(write(make_update(entities_.title, entities_.title_model, shot_->title->place_world,
                                   {0, shot_->title->yaw_deg, 0})));
    return write(make_update(entities_.camera, entities_.camera_model, pose.place_world, pose.angles_deg));
  }

  const FilmScript& script_;
  const FilmScene& scene_;
  const CameraPoses& poses_;
  FilmEntities entities_;
  formats::DemWriter& io_writer_;
  net::Dialect dialect_;
  base::ByteWriter record_;
  std::optional<std::size_t> record_offset_;
  math::Vec3 angles_deg_{0.0f};
  const Shot* shot_ = nullptr;
  const Shot* last_shot_ = nullptr;
  bool is_playing_ = false, has_camera_ = false;
  // The demo's time of the current tick; the film's; and the first minus the second.
  float tick_s_ = 0, film_s_ = 0, moved_s_ = 0;
};

}  // namespace

base::Status FilmWriter::add(const FilmScene& scene, base::Bytes demo, const CameraPoses& poses) {
  if (has_scene_) {
    // A level of a demo begins with this command, as on a server.
    base::ByteWriter change;
    TRY_STATUS(net::write_message(net::StuffText{"reconnect\n"}, {}, change));
    writer_.add(math::Vec3(0.0f), change.view());
  }
  has_scene_ = true;
  TRY(const FilmEntities entities, choose_entities(demo));
  for (const Shot& shot : scene.shots) length_s_ += shot.end_s - shot.begin_s;
  return SceneCutter(script_, scene, poses, entities, writer_).cut(demo);
}

base::ByteVector FilmWriter::finish() && {
  base::ByteWriter end;
  CHECK(net::write_message(net::Disconnect{}, {}, end).ok(), "a disconnect fits in every dialect");
  writer_.add(math::Vec3(0.0f), end.view());
  return std::move(writer_).take();
}

}  // namespace temblor::player
