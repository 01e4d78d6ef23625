#include "net/delta/sent_snapshots.h"

namespace temblor::net {

void SentSnapshots::reset() {
  for (Entry& entry : entries_) entry.number.reset();
  acknowledged_.reset();
}

SnapshotState& SentSnapshots::begin_snapshot() {
  Entry& current = entry(next_);
  current.number.reset();
  current.snapshot.state.clear();
  return current.snapshot.state;
}

void SentSnapshots::write(base::ByteWriter& io_writer) {
  // A client keeps as many snapshots as we do, so an older reference is gone there, too: send everything.
  const std::uint32_t back = acknowledged_ ? next_ - *acknowledged_ : 0;
  const bool has_reference = back > 0 && back < kReferenceSnapshots;
  io_writer.u8(kDeltaPacket);
  io_writer.u16(static_cast<std::uint16_t>(next_));
  io_writer.u8(static_cast<std::uint8_t>(has_reference ? back : 0));
  Entry& current = entry(next_);
  write_delta(has_reference ? &entry(next_ - back).snapshot : nullptr, static_cast<int>(back),
              current.snapshot, io_writer);
  current.number = next_;
}

void SentSnapshots::acknowledge(std::uint16_t number) {
  // The packet holds the low 16 bits of the number; the distance to next_ restores the rest.
  const auto back = static_cast<std::uint16_t>(static_cast<std::uint16_t>(next_) - number);
  if (back == 0 || back >= kReferenceSnapshots || back > next_) return;
  const std::uint32_t full_number = next_ - back;
  // Packets may overtake each other: the newest acknowledgment counts.
  if (entry(full_number).number != full_number || (acknowledged_ && full_number < *acknowledged_)) return;
  acknowledged_ = full_number;
}

void ReceivedSnapshots::reset() {
  for (Entry& entry : entries_) entry.number.reset();
  latest_.reset();
}

base::Result<std::optional<base::Bytes>> ReceivedSnapshots::read(base::Bytes packet, const Dialect& dialect) {
  base::ByteReader reader(packet);
  const std::uint8_t kind = reader.u8();
  const std::uint16_t number = reader.u16();
  const std::uint8_t back = reader.u8();
  if (!reader.ok() || kind != kDeltaPacket) return base::malformed("snapshot header is incomplete");
  if (back >= kReferenceSnapshots)
    return base::malformed("snapshot refers {} snapshots back, the limit is {}", back,
                           kReferenceSnapshots - 1);
  Entry* reference = nullptr;
  if (back > 0) {
    const auto reference_number = static_cast<std::uint16_t>(number - back);
    reference = &entries_[reference_number % kReferenceSnapshots];
    if (reference->number != reference_number) return std::optional<base::Bytes>{};
  }
  // `back` is less than kReferenceSnapshots, so this is never the entry of the reference. It has no number
  // until the snapshot is complete, so a damaged one never becomes a reference.
  Entry& current = entries_[number % kReferenceSnapshots];
  current.number.reset();
  TRY_STATUS(read_delta(packet.subspan(reader.offset()),
                        reference != nullptr ? &reference->snapshot : nullptr, back, current.snapshot));
  current.number = number;
  latest_ = number;
  bytes_.truncate(0);
  writer_.write(current.snapshot.state, dialect, bytes_);
  return std::optional<base::Bytes>(bytes_.view());
}

}  // namespace temblor::net
