#include "net/delta/delta.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <span>

#include "base/check.h"

namespace temblor::net {
namespace {

constexpr int kLengthBits = 5, kPlainSizeBits = 11, kWordCountBits = 5;
constexpr int kRateSteps = 16;
constexpr std::uint32_t kMaxNumber = 65535;

std::uint32_t expected(std::uint32_t before, std::int32_t rate, int back) {
  return before + static_cast<std::uint32_t>(std::int64_t{rate} * back / kRateSteps);
}

std::int32_t rate(std::uint32_t before, std::uint32_t now, int back) {
  const std::int64_t way = std::int64_t{static_cast<std::int32_t>(now - before)} * kRateSteps / back;
  using Limits = std::numeric_limits<std::int32_t>;
  return static_cast<std::int32_t>(std::clamp<std::int64_t>(way, Limits::min(), Limits::max()));
}

// Each member is both ways: for the encoder it says what it is given; for the decoder it replaces that by
// what was said.
template <typename Coder>
class Exchange {
 public:
  // `back`: how many updates ago `before` was; 0: there is none.
  Exchange(Coder& io_coder, SnapshotModel& io_model, int back)
      : coder_(io_coder), model_(io_model), back_(back) {}

  bool flag(BitModel& io_model, bool value) { return coder_.bit(io_model, value); }

  // A word that is known to differ from what was expected.
  std::uint32_t number(NumberModel& io_model, std::uint32_t before, std::uint32_t now) {
    const std::uint32_t difference = now - before;
    const bool is_negative = coder_.bit(io_model.negative, difference >> 31 != 0);
    const std::uint32_t magnitude = is_negative ? 0 - difference : difference;
    const int length = bit_length(io_model, std::bit_width(magnitude));
    // The highest bit is 1.
    const std::uint32_t high = 1u << (length - 1);
    const std::uint32_t rest = coder_.plain(magnitude & (high - 1), length - 1);
    const std::uint32_t read = high | rest;
    return before + (is_negative ? 0 - read : read);
  }

  // Returns which have changed, a bit each.
  std::uint32_t words(std::span<WordModel> io_models, std::span<const std::uint32_t> before,
                      std::uint32_t changed_before, std::span<std::uint32_t> io_now) {
    std::uint32_t changed = 0;
    for (std::size_t i = 0; i < io_now.size(); ++i) {
      WordModel& model = io_models[i];
      const bool changes = coder_.bit(model.changes[changed_before >> i & 1], io_now[i] != before[i]);
      io_now[i] = changes ? number(model.difference, before[i], io_now[i]) : before[i];
      changed |= changes ? 1u << i : 0u;
    }
    return changed;
  }

  void head(const SnapshotState& before, SnapshotState& io_now) {
    io_now.has_time = flag(model_.has_time, io_now.has_time);
    if (io_now.has_time) time(before, io_now);
    plain_bytes(model_.has_once, io_now.once);
    io_now.has_client_data = flag(model_.has_client_data, io_now.has_client_data);
    if (io_now.has_client_data)
      io_now.client_data_changed =
          words(model_.client_data, before.client_data, before.client_data_changed, io_now.client_data);
    acknowledgement(before, io_now);
  }

  void time(const SnapshotState& before, SnapshotState& io_now) {
    const std::uint32_t expected_time = expected(before.time, before.time_rate, back_);
    words(std::span(&model_.time, 1), std::span(&expected_time, 1), 1, std::span(&io_now.time, 1));
    if (back_ > 0) io_now.time_rate = rate(before.time, io_now.time, back_);
  }

  void acknowledgement(const SnapshotState& before, SnapshotState& io_now) {
    if (!flag(model_.has_acknowledgement, io_now.acknowledgement_words > 0)) {
      io_now.acknowledgement_words = 0;
      return;
    }
    const bool is_as_long = io_now.acknowledgement_words == before.acknowledgement_words;
    if (flag(model_.acknowledgement_resizes, !is_as_long || before.acknowledgement_words == 0))
      io_now.acknowledgement_words =
          1 + coder_.plain(static_cast<std::uint32_t>(io_now.acknowledgement_words) - 1, kWordCountBits);
    else
      io_now.acknowledgement_words = before.acknowledgement_words;
    auto expected_words = before.acknowledgement;
    for (std::size_t i = 0; i < SnapshotState::kMovingAcknowledgement; ++i)
      expected_words[i] = expected(expected_words[i], before.acknowledgement_rates[i], back_);
    io_now.acknowledgement_changed =
        words(model_.acknowledgement, expected_words, before.acknowledgement_changed,
              std::span(io_now.acknowledgement).first(io_now.acknowledgement_words));
    if (back_ == 0 || before.acknowledgement_words == 0) return;
    for (std::size_t i = 0; i < SnapshotState::kMovingAcknowledgement; ++i)
      io_now.acknowledgement_rates[i] = rate(before.acknowledgement[i], io_now.acknowledgement[i], back_);
  }

  // Never told before: as they are.
  void plain_bytes(BitModel& io_model, base::ByteWriter& io_bytes) {
    if (!flag(io_model, io_bytes.size() > 0)) return io_bytes.truncate(0);
    const std::uint32_t size = coder_.plain(static_cast<std::uint32_t>(io_bytes.size()), kPlainSizeBits);
    for (std::uint32_t i = 0; i < size; ++i) {
      if (i < io_bytes.size())
        coder_.plain(std::to_integer<std::uint32_t>(io_bytes.view()[i]), 8);
      else
        io_bytes.u8(static_cast<std::uint8_t>(coder_.plain(0, 8)));
    }
  }

  // One that the state before has; `now` null: it is gone. Returns whether it is still there.
  bool known_entity(const SnapshotState::Entity& before, const SnapshotState::Entity* now,
                    SnapshotState::Entity& out_entity) {
    const std::size_t context = before.changed != 0 ? 1 : 0;
    if (flag(model_.is_gone[context], now == nullptr)) return false;
    out_entity = now != nullptr ? *now : before;
    out_entity.number = before.number;
    const auto expected_words = expected_of(before);
    const bool changes = flag(model_.changes[context], out_entity.words != expected_words);
    if (!changes) out_entity.words = expected_words;
    out_entity.changed = changes ? static_cast<std::uint16_t>(
                                       words(model_.entity, expected_words, before.changed, out_entity.words))
                                 : std::uint16_t{0};
    for (std::size_t i = 0; i < SnapshotState::kMoving; ++i) {
      const std::size_t word = SnapshotState::kFirstMoving + i;
      out_entity.rates[i] = rate(before.words[word], out_entity.words[word], back_);
    }
    return true;
  }

  // Whether there is another one; its number is above the last one's (0 before the first).
  bool has_new(bool value) { return flag(model_.has_new, value); }
  std::uint32_t new_entity(std::uint32_t last_number, SnapshotState::Entity& io_entity) {
    constexpr std::array<std::uint32_t, SnapshotState::kEntityWords> kNothing{};
    const std::uint32_t number = this->number(model_.new_number, last_number, io_entity.number);
    io_entity.number = static_cast<std::uint16_t>(number);
    words(model_.new_entity, kNothing, 0, io_entity.words);
    io_entity.changed = (1u << SnapshotState::kEntityWords) - 1;
    return number;
  }

  void tail(SnapshotState& io_now) { plain_bytes(model_.has_events, io_now.events); }

 private:
  std::array<std::uint32_t, SnapshotState::kEntityWords> expected_of(
      const SnapshotState::Entity& before) const {
    auto words = before.words;
    if (SnapshotState::is_stepping(before)) return words;
    for (std::size_t i = 0; i < SnapshotState::kMoving; ++i) {
      std::uint32_t& word = words[SnapshotState::kFirstMoving + i];
      word = expected(word, before.rates[i], back_);
    }
    return words;
  }

  // 1 to 32.
  int bit_length(NumberModel& io_model, int length) {
    const auto told = static_cast<std::uint32_t>(length - 1);
    std::uint32_t read = 1;
    for (int i = kLengthBits - 1; i >= 0; --i)
      read = read << 1 | (coder_.bit(io_model.length[read], (told >> i & 1) != 0) ? 1u : 0u);
    return static_cast<int>(read - (1u << kLengthBits)) + 1;
  }

  Coder& coder_;
  SnapshotModel& model_;
  int back_;
};

const SnapshotState& nothing() {
  static const SnapshotState kNothing;
  return kNothing;
}

void write_entities(const SnapshotState& before, SnapshotState& io_now, Exchange<BitEncoder>& io_exchange) {
  // Both in order: those of `before`, each with the one of its number.
  auto now = io_now.entities.begin();
  for (const SnapshotState::Entity& entity : before.entities) {
    while (now != io_now.entities.end() && now->number < entity.number) ++now;
    const bool is_there = now != io_now.entities.end() && now->number == entity.number;
    SnapshotState::Entity told;
    if (io_exchange.known_entity(entity, is_there ? &*now : nullptr, told)) *now = told;
  }
  auto known = before.entities.begin();
  std::uint32_t last_number = 0;
  for (SnapshotState::Entity& entity : io_now.entities) {
    while (known != before.entities.end() && known->number < entity.number) ++known;
    if (known != before.entities.end() && known->number == entity.number) continue;
    CHECK(entity.number > last_number, "in order, each once");
    io_exchange.has_new(true);
    last_number = io_exchange.new_entity(last_number, entity);
  }
  io_exchange.has_new(false);
}

base::Error too_short() {
  return base::malformed("a difference ends too soon");
}

base::Status read_entities(const BitDecoder& decoder, const SnapshotState& before, SnapshotState& out_now,
                           Exchange<BitDecoder>& io_exchange) {
  std::vector<SnapshotState::Entity>& entities = out_now.entities;
  entities.clear();
  for (const SnapshotState::Entity& entity : before.entities) {
    SnapshotState::Entity told;
    if (io_exchange.known_entity(entity, &entity, told)) entities.push_back(told);
    if (decoder.is_past_end()) return too_short();
  }
  const auto known = static_cast<std::ptrdiff_t>(entities.size());
  std::uint32_t last_number = 0;
  while (io_exchange.has_new(false)) {
    SnapshotState::Entity told;
    const std::uint32_t number = io_exchange.new_entity(last_number, told);
    if (decoder.is_past_end()) return too_short();
    if (number <= last_number || number > kMaxNumber)
      return base::malformed("entity {} follows entity {}", number, last_number);
    if (entities.size() == SnapshotState::kMaxEntities)
      return base::malformed("more than {} entities", SnapshotState::kMaxEntities);
    last_number = number;
    entities.push_back(told);
  }
  const auto by_number = [](const SnapshotState::Entity& a, const SnapshotState::Entity& b) {
    return a.number < b.number;
  };
  std::inplace_merge(entities.begin(), entities.begin() + known, entities.end(), by_number);
  const auto twice = std::adjacent_find(entities.begin(), entities.end(),
                                        [](const auto& a, const auto& b) { return a.number == b.number; });
  if (twice != entities.end()) return base::malformed("entity {} is new, and known", twice->number);
  return base::Ok{};
}

}  // namespace

void write_delta(const ReferenceSnapshot* before, int back, ReferenceSnapshot& io_now,
                 base::ByteWriter& io_writer) {
  CHECK(before == nullptr || back > 0);
  CHECK(io_now.state.entities.size() <= SnapshotState::kMaxEntities);
  CHECK(io_now.state.once.size() <= SnapshotState::kMaxPlainBytes);
  CHECK(io_now.state.events.size() <= SnapshotState::kMaxPlainBytes);
  io_now.model = before != nullptr ? before->model : SnapshotModel{};
  const SnapshotState& old = before != nullptr ? before->state : nothing();
  BitEncoder encoder(io_writer);
  Exchange exchange(encoder, io_now.model, before != nullptr ? back : 0);
  exchange.head(old, io_now.state);
  write_entities(old, io_now.state, exchange);
  exchange.tail(io_now.state);
  encoder.finish();
}

base::Status read_delta(base::Bytes bytes, const ReferenceSnapshot* before, int back,
                        ReferenceSnapshot& out_now) {
  CHECK(before == nullptr || back > 0);
  out_now.state.clear();
  out_now.model = before != nullptr ? before->model : SnapshotModel{};
  const SnapshotState& old = before != nullptr ? before->state : nothing();
  BitDecoder decoder(bytes);
  Exchange exchange(decoder, out_now.model, before != nullptr ? back : 0);
  exchange.head(old, out_now.state);
  TRY_STATUS(read_entities(decoder, old, out_now.state, exchange));
  exchange.tail(out_now.state);
  if (decoder.is_past_end()) return too_short();
  return base::Ok{};
}

}  // namespace temblor::net
