#include "net/delta/sent_snapshots.h"

namespace temblor::net {

void SentSnapshots::forget() {
  for (Told& told : kept_) told.number.reset();
  acknowledged_.reset();
}

SnapshotState& SentSnapshots::next() {
  Told& told = at(next_);
  told.number.reset();
  told.update.state.clear();
  return told.update.state;
}

void SentSnapshots::write(base::ByteWriter& io_writer) {
  const std::uint32_t back = acknowledged_ ? next_ - *acknowledged_ : 0;
  const bool has_one = back > 0 && back < kReferenceSnapshots;
  io_writer.u8(kDeltaPacket);
  io_writer.u16(static_cast<std::uint16_t>(next_));
  io_writer.u8(static_cast<std::uint8_t>(has_one ? back : 0));
  Told& told = at(next_);
  write_delta(has_one ? &at(next_ - back).update : nullptr, static_cast<int>(back), told.update, io_writer);
  told.number = next_;
}

void SentSnapshots::acknowledge(std::uint16_t number) {
  const auto back = static_cast<std::uint16_t>(static_cast<std::uint16_t>(next_) - number);
  if (back == 0 || back >= kReferenceSnapshots || back > next_) return;
  const std::uint32_t whole = next_ - back;
  if (at(whole).number != whole || (acknowledged_ && whole < *acknowledged_)) return;
  acknowledged_ = whole;
}

void ReceivedSnapshots::forget() {
  for (Known& known : kept_) known.number.reset();
  latest_.reset();
}

base::Result<std::optional<base::Bytes>> ReceivedSnapshots::read(base::Bytes packet, const Dialect& dialect) {
  base::ByteReader reader(packet);
  const std::uint8_t kind = reader.u8();
  const std::uint16_t number = reader.u16();
  const std::uint8_t back = reader.u8();
  if (!reader.ok() || kind != kDeltaPacket) return base::malformed("a difference's header has no end");
  if (back >= kReferenceSnapshots) return base::malformed("an update is told against one {} before", back);
  Known* before = nullptr;
  if (back > 0) {
    const auto before_number = static_cast<std::uint16_t>(number - back);
    before = &kept_[before_number % kReferenceSnapshots];
    if (before->number != before_number) return std::optional<base::Bytes>{};
  }
  Known& known = kept_[number % kReferenceSnapshots];
  known.number.reset();
  TRY_STATUS(read_delta(packet.subspan(reader.offset()), before != nullptr ? &before->update : nullptr, back,
                        known.update));
  known.number = number;
  latest_ = number;
  bytes_.truncate(0);
  writer_.write(known.update.state, dialect, bytes_);
  return std::optional<base::Bytes>(bytes_.view());
}

}  // namespace temblor::net
