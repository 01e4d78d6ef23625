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
constexpr int kRateSteps = 16;  // rates are in 16ths per snapshot
constexpr std::uint32_t kMaxNumber = 65535;

// Extrapolates a word over `back` snapshots. Words wrap around.
std::uint32_t predict(std::uint32_t before, std::int32_t rate, int back) {
  return before + static_cast<std::uint32_t>(std::int64_t{rate} * back / kRateSteps);
}

// Returns the speed of a word, in 16ths per snapshot.
std::int32_t compute_rate(std::uint32_t before, std::uint32_t now, int back) {
  const std::int64_t way = std::int64_t{static_cast<std::int32_t>(now - before)} * kRateSteps / back;
  using Limits = std::numeric_limits<std::int32_t>;
  return static_cast<std::int32_t>(std::clamp<std::int64_t>(way, Limits::min(), Limits::max()));
}

// The format, for both directions:
//
//   head      [time] | once | [client data] | [acknowledgment]
//   entities  for each entity of the reference: gone, as predicted, or the words that differ
//             for each new entity: 1 | number | words; then 0
//   tail      events
//
// With a BitEncoder, each member function writes its argument; with a
// BitDecoder, it ignores the argument and returns or stores the decoded value. So reader and writer cannot
// disagree.
template <typename Coder>
class DeltaCoder {
 public:
  // `back`: age of the reference in snapshots; 0: no reference.
  DeltaCoder(Coder& io_coder, SnapshotModel& io_model, int back)
      : coder_(io_coder), model_(io_model), back_(back) {}

  bool flag(BitModel& io_model, bool value) { return coder_.bit(io_model, value); }

  // A word that differs from its prediction `before`.
  std::uint32_t number(NumberModel& io_model, std::uint32_t before, std::uint32_t now) {
    const std::uint32_t difference = now - before;
    const bool is_negative = coder_.bit(io_model.negative, difference >> 31 != 0);
    const std::uint32_t magnitude = is_negative ? 0 - difference : difference;
    const int length = bit_length(io_model, std::bit_width(magnitude));
    // The highest bit is always 1 and not coded.
    const std::uint32_t high = 1u << (length - 1);
    const std::uint32_t rest = coder_.raw_bits(magnitude & (high - 1), length - 1);
    const std::uint32_t read = high | rest;
    return before + (is_negative ? 0 - read : read);
  }

  // Words with the predictions `before`. Returns the mask of those that differ. `changed_before`: the mask
  // that was returned for the reference; a word that differed then has a model of its own.
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

  // Everything before the entities.
  void head(const SnapshotState& before, SnapshotState& io_now) {
    io_now.has_time = flag(model_.has_time, io_now.has_time);
    if (io_now.has_time) time(before, io_now);
    raw_bytes(model_.has_once, io_now.once);
    io_now.has_client_data = flag(model_.has_client_data, io_now.has_client_data);
    if (io_now.has_client_data)
      io_now.client_data_changed =
          words(model_.client_data, before.client_data, before.client_data_changed, io_now.client_data);
    acknowledgment(before, io_now);
  }

  void time(const SnapshotState& before, SnapshotState& io_now) {
    const std::uint32_t predicted_time = predict(before.time, before.time_rate, back_);
    words(std::span(&model_.time, 1), std::span(&predicted_time, 1), 1, std::span(&io_now.time, 1));
    if (back_ > 0) io_now.time_rate = compute_rate(before.time, io_now.time, back_);
  }

  void acknowledgment(const SnapshotState& before, SnapshotState& io_now) {
    if (!flag(model_.has_acknowledgment, io_now.acknowledgment_words > 0)) {
      io_now.acknowledgment_words = 0;
      return;
    }
    const bool is_as_long = io_now.acknowledgment_words == before.acknowledgment_words;
    if (flag(model_.acknowledgment_resizes, !is_as_long || before.acknowledgment_words == 0))
      io_now.acknowledgment_words =
          1 + coder_.raw_bits(static_cast<std::uint32_t>(io_now.acknowledgment_words) - 1, kWordCountBits);
    else
      io_now.acknowledgment_words = before.acknowledgment_words;
    auto predicted_words = before.acknowledgment;
    for (std::size_t i = 0; i < SnapshotState::kMovingAcknowledgment; ++i)
      predicted_words[i] = predict(predicted_words[i], before.acknowledgment_rates[i], back_);
    io_now.acknowledgment_changed =
        words(model_.acknowledgment, predicted_words, before.acknowledgment_changed,
              std::span(io_now.acknowledgment).first(io_now.acknowledgment_words));
    if (back_ == 0 || before.acknowledgment_words == 0) return;
    for (std::size_t i = 0; i < SnapshotState::kMovingAcknowledgment; ++i)
      io_now.acknowledgment_rates[i] =
          compute_rate(before.acknowledgment[i], io_now.acknowledgment[i], back_);
  }

  // Messages that no reference can predict. A decoder starts with an empty `io_bytes` and fills it.
  void raw_bytes(BitModel& io_model, base::ByteWriter& io_bytes) {
    if (!flag(io_model, io_bytes.size() > 0)) return io_bytes.truncate(0);
    const std::uint32_t size = coder_.raw_bits(static_cast<std::uint32_t>(io_bytes.size()), kPlainSizeBits);
    for (std::uint32_t i = 0; i < size; ++i) {
      if (i < io_bytes.size())
        coder_.raw_bits(std::to_integer<std::uint32_t>(io_bytes.view()[i]), 8);
      else
        io_bytes.u8(static_cast<std::uint8_t>(coder_.raw_bits(0, 8)));
    }
  }

  // An entity of the reference. `now`: null if it is gone. Returns whether it is still there.
  bool known_entity(const SnapshotState::Entity& before, const SnapshotState::Entity* now,
                    SnapshotState::Entity& out_entity) {
    const std::size_t context = before.changed != 0 ? 1 : 0;
    if (flag(model_.is_gone[context], now == nullptr)) return false;
    out_entity = now != nullptr ? *now : before;
    out_entity.number = before.number;
    const auto predicted_words = predict_words(before);
    const bool changes = flag(model_.changes[context], out_entity.words != predicted_words);
    if (!changes) out_entity.words = predicted_words;
    out_entity.changed = changes ? static_cast<std::uint16_t>(words(model_.entity, predicted_words,
                                                                    before.changed, out_entity.words))
                                 : std::uint16_t{0};
    for (std::size_t i = 0; i < SnapshotState::kMoving; ++i) {
      const std::size_t word = SnapshotState::kFirstMoving + i;
      out_entity.rates[i] = compute_rate(before.words[word], out_entity.words[word], back_);
    }
    return true;
  }

  // Whether another new entity follows. New entities are sorted by number; last_number is 0 before the first.
  bool has_new(bool value) { return flag(model_.has_new, value); }
  std::uint32_t new_entity(std::uint32_t last_number, SnapshotState::Entity& io_entity) {
    constexpr std::array<std::uint32_t, SnapshotState::kEntityWords> kNoWords{};
    const std::uint32_t number = this->number(model_.new_number, last_number, io_entity.number);
    io_entity.number = static_cast<std::uint16_t>(number);
    words(model_.new_entity, kNoWords, 0, io_entity.words);
    io_entity.changed = (1u << SnapshotState::kEntityWords) - 1;
    return number;
  }

  void tail(SnapshotState& io_now) { raw_bytes(model_.has_events, io_now.events); }

 private:
  std::array<std::uint32_t, SnapshotState::kEntityWords> predict_words(
      const SnapshotState::Entity& before) const {
    auto words = before.words;
    if (SnapshotState::is_stepping(before)) return words;
    for (std::size_t i = 0; i < SnapshotState::kMoving; ++i) {
      std::uint32_t& word = words[SnapshotState::kFirstMoving + i];
      word = predict(word, before.rates[i], back_);
    }
    return words;
  }

  // Bit length from 1 to 32, as a path through a binary tree.
  int bit_length(NumberModel& io_model, int length) {
    const auto coded = static_cast<std::uint32_t>(length - 1);
    std::uint32_t read = 1;
    for (int i = kLengthBits - 1; i >= 0; --i)
      read = read << 1 | (coder_.bit(io_model.length[read], (coded >> i & 1) != 0) ? 1u : 0u);
    return static_cast<int>(read - (1u << kLengthBits)) + 1;
  }

  Coder& coder_;
  SnapshotModel& model_;
  int back_;
};

// Stands for a missing reference.
const SnapshotState& empty_state() {
  static const SnapshotState kEmpty;
  return kEmpty;
}

// Entities that the reference has come first, in its order, so they need no numbers. The coder stores rates
// and change masks in io_now, which may be a reference later.
void write_entities(const SnapshotState& before, SnapshotState& io_now, DeltaCoder<BitEncoder>& io_coder) {
  // Both lists are sorted by number: merge them.
  auto now = io_now.entities.begin();
  for (const SnapshotState::Entity& entity : before.entities) {
    while (now != io_now.entities.end() && now->number < entity.number) ++now;
    const bool is_there = now != io_now.entities.end() && now->number == entity.number;
    SnapshotState::Entity coded;
    if (io_coder.known_entity(entity, is_there ? &*now : nullptr, coded)) *now = coded;
  }
  auto known = before.entities.begin();
  std::uint32_t last_number = 0;
  for (SnapshotState::Entity& entity : io_now.entities) {
    while (known != before.entities.end() && known->number < entity.number) ++known;
    if (known != before.entities.end() && known->number == entity.number) continue;
    CHECK(entity.number > last_number, "entities must be sorted by number");
    io_coder.has_new(true);
    last_number = io_coder.new_entity(last_number, entity);
  }
  io_coder.has_new(false);
}

base::Error make_too_short_error() {
  return base::malformed("snapshot delta ends too early");
}

// Checks for the end of the input after each entity, so that damaged bytes cannot make it read on and on.
base::Status read_entities(const BitDecoder& decoder, const SnapshotState& before, SnapshotState& out_now,
                           DeltaCoder<BitDecoder>& io_coder) {
  std::vector<SnapshotState::Entity>& entities = out_now.entities;
  entities.clear();
  for (const SnapshotState::Entity& entity : before.entities) {
    SnapshotState::Entity decoded;
    // A decoder ignores the values of its arguments: `&entity` only says that there is an entity.
    if (io_coder.known_entity(entity, &entity, decoded)) entities.push_back(decoded);
    if (decoder.is_past_end()) return make_too_short_error();
  }
  const auto known = static_cast<std::ptrdiff_t>(entities.size());
  std::uint32_t last_number = 0;
  while (io_coder.has_new(false)) {
    SnapshotState::Entity decoded;
    const std::uint32_t number = io_coder.new_entity(last_number, decoded);
    if (decoder.is_past_end()) return make_too_short_error();
    if (number <= last_number || number > kMaxNumber)
      return base::malformed("new entity {} after entity {}", number, last_number);
    if (entities.size() == SnapshotState::kMaxEntities)
      return base::malformed("more than {} entities", SnapshotState::kMaxEntities);
    last_number = number;
    entities.push_back(decoded);
  }
  const auto by_number = [](const SnapshotState::Entity& a, const SnapshotState::Entity& b) {
    return a.number < b.number;
  };
  std::inplace_merge(entities.begin(), entities.begin() + known, entities.end(), by_number);
  const auto duplicate = std::adjacent_find(
      entities.begin(), entities.end(), [](const auto& a, const auto& b) { return a.number == b.number; });
  if (duplicate != entities.end())
    return base::malformed("entity {} is both new and in the reference", duplicate->number);
  return base::Ok{};
}

}  // namespace

void write_delta(const ReferenceSnapshot* reference, int back, ReferenceSnapshot& io_now,
                 base::ByteWriter& io_writer) {
  CHECK(reference == nullptr || back > 0);
  CHECK(io_now.state.entities.size() <= SnapshotState::kMaxEntities);
  CHECK(io_now.state.once.size() <= SnapshotState::kMaxPlainBytes);
  CHECK(io_now.state.events.size() <= SnapshotState::kMaxPlainBytes);
  io_now.model = reference != nullptr ? reference->model : SnapshotModel{};
  const SnapshotState& before = reference != nullptr ? reference->state : empty_state();
  BitEncoder encoder(io_writer);
  DeltaCoder coder(encoder, io_now.model, reference != nullptr ? back : 0);
  coder.head(before, io_now.state);
  write_entities(before, io_now.state, coder);
  coder.tail(io_now.state);
  encoder.finish();
}

base::Status read_delta(base::Bytes bytes, const ReferenceSnapshot* reference, int back,
                        ReferenceSnapshot& out_now) {
  CHECK(reference == nullptr || back > 0);
  out_now.state.clear();
  out_now.model = reference != nullptr ? reference->model : SnapshotModel{};
  const SnapshotState& before = reference != nullptr ? reference->state : empty_state();
  BitDecoder decoder(bytes);
  DeltaCoder coder(decoder, out_now.model, reference != nullptr ? back : 0);
  coder.head(before, out_now.state);
  TRY_STATUS(read_entities(decoder, before, out_now.state, coder));
  coder.tail(out_now.state);
  if (decoder.is_past_end()) return make_too_short_error();
  return base::Ok{};
}

}  // namespace temblor::net
