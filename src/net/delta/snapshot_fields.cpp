#include "net/delta/snapshot_fields.h"

#include <array>

#include "net/delta/snapshot_state.h"
#include "net/wire/client_data.h"
#include "net/wire/encoding.h"
#include "net/wire/entity_update.h"
#include "net/wire/message_id.h"

namespace temblor::net {
namespace {

// Reads fields of a message as words. The member functions are those of WordWriter, so that one template
// visits the fields for both.
class WordReader {
 public:
  WordReader(base::Bytes bytes, const Dialect& dialect)
      : bytes_(bytes), coord_(coord_encoding(dialect)), angle_(angle_encoding(dialect)) {}

  std::uint32_t u8() { return bytes_.u8(); }
  std::uint32_t u16() { return bytes_.u16(); }
  void low(std::uint32_t& out_word) { out_word = bytes_.u8(); }
  void high(std::uint32_t& io_word) { io_word |= std::uint32_t{bytes_.u8()} << 8; }
  void i8(std::uint32_t& out_word) { out_word = signed_word(bytes_.read<std::int8_t>()); }
  void i16(std::uint32_t& out_word) { out_word = signed_word(bytes_.i16()); }
  void u32(std::uint32_t& out_word) { out_word = bytes_.u32(); }
  void coord(std::uint32_t& out_word) {
    switch (coord_) {
      case CoordEncoding::kEighths16:
        return i16(out_word);
      case CoordEncoding::kWholeAnd255: {
        // One word for both parts, so that a small step is a small difference, also across a whole unit.
        const auto whole = signed_word(bytes_.i16());
        out_word = whole << 8 | bytes_.u8();
        return;
      }
      case CoordEncoding::kSixteenths32:
      case CoordEncoding::kFloat:
        return u32(out_word);
    }
  }
  void angle(std::uint32_t& out_word) {
    switch (angle_) {
      case AngleEncoding::kByte:
        return i8(out_word);
      case AngleEncoding::kShort:
        return i16(out_word);
      case AngleEncoding::kFloat:
        return u32(out_word);
    }
  }
  // True if the fields were exactly the whole message.
  bool is_whole() const { return bytes_.ok() && bytes_.remaining() == 0; }

 private:
  static std::uint32_t signed_word(std::int32_t value) { return static_cast<std::uint32_t>(value); }

  base::ByteReader bytes_;
  CoordEncoding coord_;
  AngleEncoding angle_;
};

// The inverse of WordReader.
class WordWriter {
 public:
  WordWriter(const Dialect& dialect, base::ByteWriter& io_bytes)
      : bytes_(io_bytes), coord_(coord_encoding(dialect)), angle_(angle_encoding(dialect)) {}

  void u8(std::uint32_t word) { bytes_.u8(static_cast<std::uint8_t>(word)); }
  void u16(std::uint32_t word) { bytes_.u16(static_cast<std::uint16_t>(word)); }
  void low(std::uint32_t word) { u8(word); }
  void high(std::uint32_t word) { u8(word >> 8); }
  void i8(std::uint32_t word) { u8(word); }
  void i16(std::uint32_t word) { u16(word); }
  void u32(std::uint32_t word) { bytes_.u32(word); }
  void coord(std::uint32_t word) {
    switch (coord_) {
      case CoordEncoding::kEighths16:
        return u16(word);
      case CoordEncoding::kWholeAnd255:
        u16(word >> 8);
        return u8(word);
      case CoordEncoding::kSixteenths32:
      case CoordEncoding::kFloat:
        return u32(word);
    }
  }
  void angle(std::uint32_t word) {
    switch (angle_) {
      case AngleEncoding::kByte:
        return u8(word);
      case AngleEncoding::kShort:
        return u16(word);
      case AngleEncoding::kFloat:
        return u32(word);
    }
  }

 private:
  base::ByteWriter& bytes_;
  CoordEncoding coord_;
  AngleEncoding angle_;
};

// Index of each field among the words.
enum EntityWord : std::size_t {
  kFlags,
  kModel,
  kFrame,
  kColormap,
  kSkin,
  kEffects,
  kOrigin,
  kAngles = kOrigin + 3,
  kAlpha = kAngles + 3,
  kScale,
  kNextThink,
  kEntityWordsEnd
};
static_assert(kEntityWordsEnd == SnapshotState::kEntityWords);
static_assert(kOrigin == SnapshotState::kFirstMoving && kAlpha == kOrigin + SnapshotState::kMoving);

// Visits the fields after flags and number in wire order; reads or writes them.
template <typename Wire, typename Word>
void visit_entity_fields(Wire& io_wire, std::span<Word> words) {
  namespace flag = entity_flag;
  const std::uint32_t flags = words[kFlags];
  if (flags & flag::kModel) io_wire.low(words[kModel]);
  if (flags & flag::kFrame) io_wire.low(words[kFrame]);
  if (flags & flag::kColormap) io_wire.low(words[kColormap]);
  if (flags & flag::kSkin) io_wire.low(words[kSkin]);
  if (flags & flag::kEffects) io_wire.low(words[kEffects]);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (flags & flag::kOrigin[axis]) io_wire.coord(words[kOrigin + axis]);
    if (flags & flag::kAngle[axis]) io_wire.angle(words[kAngles + axis]);
  }
  if (flags & flag::kAlpha) io_wire.low(words[kAlpha]);
  if (flags & flag::kScale) io_wire.low(words[kScale]);
  if (flags & flag::kFrame2) io_wire.high(words[kFrame]);
  if (flags & flag::kModel2) io_wire.high(words[kModel]);
  if (flags & flag::kLerpFinish) io_wire.low(words[kNextThink]);
}

enum ClientWord : std::size_t {
  kClientFlags,
  kViewHeight,
  kIdealPitch,
  kPunch,
  kVelocity = kPunch + 3,
  kItems = kVelocity + 3,
  kWeaponFrame,
  kArmor,
  kWeaponModel,
  kHealth,
  kAmmo,
  kShells,
  kNails,
  kRockets,
  kCells,
  kActiveWeapon,
  kWeaponAlpha,
  kClientWordsEnd
};
static_assert(kClientWordsEnd == SnapshotState::kClientDataWords);

// Like visit_entity_fields(). Low bytes come before the high bytes of the same words.
template <typename Wire, typename Word>
void visit_client_data_fields(Wire& io_wire, std::span<Word> words) {
  namespace flag = client_data_flag;
  const std::uint32_t flags = words[kClientFlags];
  if (flags & flag::kViewHeight) io_wire.i8(words[kViewHeight]);
  if (flags & flag::kIdealPitch) io_wire.i8(words[kIdealPitch]);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (flags & flag::kPunch[axis]) io_wire.i8(words[kPunch + axis]);
    if (flags & flag::kVelocity[axis]) io_wire.i8(words[kVelocity + axis]);
  }
  io_wire.u32(words[kItems]);
  if (flags & flag::kWeaponFrame) io_wire.low(words[kWeaponFrame]);
  if (flags & flag::kArmor) io_wire.low(words[kArmor]);
  if (flags & flag::kWeapon) io_wire.low(words[kWeaponModel]);
  io_wire.i16(words[kHealth]);
  for (const std::size_t word : {kAmmo, kShells, kNails, kRockets, kCells, kActiveWeapon})
    io_wire.low(words[word]);
  if (flags & flag::kWeapon2) io_wire.high(words[kWeaponModel]);
  if (flags & flag::kArmor2) io_wire.high(words[kArmor]);
  if (flags & flag::kAmmo2) io_wire.high(words[kAmmo]);
  if (flags & flag::kShells2) io_wire.high(words[kShells]);
  if (flags & flag::kNails2) io_wire.high(words[kNails]);
  if (flags & flag::kRockets2) io_wire.high(words[kRockets]);
  if (flags & flag::kCells2) io_wire.high(words[kCells]);
  if (flags & flag::kWeaponFrame2) io_wire.high(words[kWeaponFrame]);
  if (flags & flag::kWeaponAlpha) io_wire.low(words[kWeaponAlpha]);
}

void clear(std::span<std::uint32_t> out_words) {
  for (std::uint32_t& word : out_words) word = 0;
}

}  // namespace

// Unknown flags stay in the flags word and so return with the message. If such a flag adds a field, the
// message is longer than the visited fields, and is_whole() fails.
bool read_entity_words(base::Bytes message, const Dialect& dialect, std::uint16_t& out_number,
                       std::span<std::uint32_t> out_words) {
  namespace flag = entity_flag;
  WordReader reader(message, dialect);
  clear(out_words);
  std::uint32_t& flags = out_words[kFlags];
  flags = reader.u8();
  if (!(flags & flag::kSignal)) return false;
  if (flags & flag::kMoreBits) flags |= reader.u8() << 8;
  if (flags & flag::kExtend1) flags |= reader.u8() << 16;
  if (flags & flag::kExtend2) return false;
  out_number = static_cast<std::uint16_t>(flags & flag::kLongEntity ? reader.u16() : reader.u8());
  visit_entity_fields(reader, out_words);
  return reader.is_whole();
}

void write_entity_words(std::uint16_t number, std::span<const std::uint32_t> words, const Dialect& dialect,
                        base::ByteWriter& io_writer) {
  namespace flag = entity_flag;
  WordWriter writer(dialect, io_writer);
  const std::uint32_t flags = words[kFlags];
  writer.u8(flags | flag::kSignal);
  if (flags & flag::kMoreBits) writer.u8(flags >> 8);
  if (flags & flag::kExtend1) writer.u8(flags >> 16);
  if (flags & flag::kLongEntity)
    writer.u16(number);
  else
    writer.u8(number);
  visit_entity_fields(writer, words);
}

bool read_client_data_words(base::Bytes message, const Dialect& dialect, std::span<std::uint32_t> out_words) {
  namespace flag = client_data_flag;
  WordReader reader(message, dialect);
  clear(out_words);
  if (reader.u8() != static_cast<std::uint8_t>(MessageId::kClientData)) return false;
  std::uint32_t& flags = out_words[kClientFlags];
  flags = reader.u16();
  if (flags & flag::kExtend1) flags |= reader.u8() << 16;
  if (flags & flag::kExtend2) flags |= reader.u8() << 24;
  visit_client_data_fields(reader, out_words);
  return reader.is_whole();
}

void write_client_data_words(std::span<const std::uint32_t> words, const Dialect& dialect,
                             base::ByteWriter& io_writer) {
  namespace flag = client_data_flag;
  WordWriter writer(dialect, io_writer);
  const std::uint32_t flags = words[kClientFlags];
  writer.u8(static_cast<std::uint8_t>(MessageId::kClientData));
  writer.u16(flags);
  if (flags & flag::kExtend1) writer.u8(flags >> 16);
  if (flags & flag::kExtend2) writer.u8(flags >> 24);
  visit_client_data_fields(writer, words);
}

}  // namespace temblor::net
