// Layout, for each light: a tag byte
//   bits 0-2  how the answer is written (Answer)
//   bit 3     one sample for each luxel
//   bit 4     only some luxels
//   bits 5-7  number of lights skipped since the last one; 7: seven plus the following varint
// then, if bit 4 is set, a bit for each luxel of the face; then the answer.
#include "compiler/light/shadows/shadow_record.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace temblor::compiler {
namespace {

enum class Answer : std::uint8_t {
  kNone,   // all in shadow
  kAll,    // all lit
  kBits,   // a bit for each luxel of the question
  kGray,   // a byte for each
  kColor,  // three bytes for each
};
constexpr std::uint8_t kAnswerBits = 7, kRough = 8, kSome = 16, kMaxSkipped = 7;
constexpr int kSkippedShift = 5;
constexpr Share kDark{0, 0, 0}, kLit{kWholeShare, kWholeShare, kWholeShare};

// The shortest way to write the shares.
Answer choose_answer(std::span<const Share> shares) {
  const Share& first = shares.front();
  const auto is_simple = [](const Share& share) { return are_equal(share, kDark) || are_equal(share, kLit); };
  if (is_simple(first) &&
      std::all_of(shares.begin(), shares.end(), [&](const Share& share) { return are_equal(share, first); }))
    return are_equal(first, kDark) ? Answer::kNone : Answer::kAll;
  if (std::all_of(shares.begin(), shares.end(), is_simple)) return Answer::kBits;
  const bool gray = std::all_of(shares.begin(), shares.end(), [](const Share& share) {
    return share[0] == share[1] && share[0] == share[2];
  });
  return gray ? Answer::kGray : Answer::kColor;
}

std::size_t count_bytes(Answer answer, std::size_t luxels) {
  switch (answer) {
    case Answer::kNone:
    case Answer::kAll:
      return 0;
    case Answer::kBits:
      return (luxels + 7) / 8;
    case Answer::kGray:
      return luxels;
    case Answer::kColor:
      return luxels * 3;
  }
  return 0;
}

// Seven bits in each byte, the lowest first; the top bit says that more follow.
void write_varint(std::uint32_t value, base::ByteWriter& io_writer) {
  for (; value >= 128; value >>= 7) io_writer.u8(static_cast<std::uint8_t>(value | 128));
  io_writer.u8(static_cast<std::uint8_t>(value));
}

std::uint32_t read_varint(base::ByteReader& io_reader) {
  std::uint32_t value = 0;
  for (unsigned shift = 0; shift < 32; shift += 7) {
    const std::uint32_t byte = io_reader.u8();
    value |= (byte & 127) << shift;
    if (byte < 128) break;
  }
  return value;
}

bool has_bit_at(base::Bytes bits, std::size_t i) {
  return (std::to_integer<unsigned>(bits[i / 8]) >> (i % 8) & 1u) != 0;
}

std::size_t count_ones(base::Bytes bits, std::size_t count) {
  std::size_t ones = 0;
  for (std::size_t i = 0; i < count; ++i) ones += has_bit_at(bits, i) ? 1 : 0;
  return ones;
}

// The share of luxel i of an answer.
Share find_share(Answer answer, base::Bytes bytes, std::size_t i) {
  const auto byte = [&](std::size_t at) { return std::to_integer<std::uint8_t>(bytes[at]); };
  switch (answer) {
    case Answer::kNone:
      break;
    case Answer::kAll:
      return kLit;
    case Answer::kBits:
      return has_bit_at(bytes, i) ? kLit : kDark;
    case Answer::kGray:
      return {byte(i), byte(i), byte(i)};
    case Answer::kColor:
      return {byte(i * 3), byte(i * 3 + 1), byte(i * 3 + 2)};
  }
  return kDark;
}

}  // namespace

// Writes `count` bits, the lowest first in each byte; those at the ascending positions `ones` are set.
void ShadowWriter::add_bits(std::span<const std::uint32_t> ones, std::size_t count) {
  std::size_t next = 0;
  for (std::size_t first = 0; first < count; first += 8) {
    unsigned byte = 0;
    for (; next < ones.size() && ones[next] < first + 8; ++next) byte |= 1u << (ones[next] - first);
    writer_.u8(static_cast<std::uint8_t>(byte));
  }
}

void ShadowWriter::add(const ShadowQuestion& question, std::span<const Share> shares) {
  CHECK(question.light >= next_light_ && !shares.empty() && shares.size() == question.luxels.size());
  const std::uint32_t skipped = question.light - next_light_;
  next_light_ = question.light + 1;
  const Answer answer = choose_answer(shares);
  const bool some = question.luxels.size() < luxels_of_face_;
  writer_.u8(static_cast<std::uint8_t>(static_cast<unsigned>(answer) | (question.rough ? kRough : 0u) |
                                       (some ? kSome : 0u) |
                                       std::min<std::uint32_t>(skipped, kMaxSkipped) << kSkippedShift));
  if (skipped >= kMaxSkipped) write_varint(skipped - kMaxSkipped, writer_);
  if (some) add_bits(question.luxels, luxels_of_face_);
  if (answer == Answer::kBits) {
    std::vector<std::uint32_t> lit;
    for (std::size_t i = 0; i < shares.size(); ++i)
      if (are_equal(shares[i], kLit)) lit.push_back(static_cast<std::uint32_t>(i));
    add_bits(lit, shares.size());
  } else if (answer == Answer::kGray) {
    for (const Share& share : shares) writer_.u8(share[0]);
  } else if (answer == Answer::kColor) {
    for (const Share& share : shares) writer_.bytes(std::as_bytes(std::span(share)));
  }
}

// Only finds where each answer is; find() decodes the one that is asked for.
ShadowReader::ShadowReader(base::Bytes record, std::size_t luxels_of_face) : luxels_of_face_(luxels_of_face) {
  base::ByteReader reader(record);
  std::uint64_t next_light = 0;
  while (reader.remaining() > 0) {
    Entry entry;
    entry.tag = reader.u8();
    std::uint64_t skipped = entry.tag >> kSkippedShift;
    if (skipped == kMaxSkipped) skipped += read_varint(reader);
    entry.luxels = static_cast<std::uint32_t>(luxels_of_face);
    if ((entry.tag & kSome) != 0) {
      entry.mask = reader.take((luxels_of_face + 7) / 8);
      if (!reader.ok()) return;
      entry.luxels = static_cast<std::uint32_t>(count_ones(entry.mask, luxels_of_face));
    }
    if ((entry.tag & kAnswerBits) > static_cast<std::uint8_t>(Answer::kColor)) return;
    entry.answer = reader.take(count_bytes(static_cast<Answer>(entry.tag & kAnswerBits), entry.luxels));
    next_light += skipped;
    if (!reader.ok() || next_light > std::numeric_limits<std::uint32_t>::max()) return;
    entry.light = static_cast<std::uint32_t>(next_light++);
    entries_.push_back(entry);
  }
}

// Equal numbers of luxels, all of which are in the mask, mean equal sets.
bool ShadowReader::asks_the_same(const Entry& entry, const ShadowQuestion& question) const {
  if (((entry.tag & kRough) != 0) != question.rough || entry.luxels != question.luxels.size()) return false;
  return std::all_of(question.luxels.begin(), question.luxels.end(), [&](std::uint32_t luxel) {
    return luxel < luxels_of_face_ && (entry.mask.empty() || has_bit_at(entry.mask, luxel));
  });
}

std::optional<std::span<const Share>> ShadowReader::find(const ShadowQuestion& question) {
  const auto entry =
      std::lower_bound(entries_.begin(), entries_.end(), question.light,
                       [](const Entry& candidate, std::uint32_t light) { return candidate.light < light; });
  if (entry == entries_.end() || entry->light != question.light || !asks_the_same(*entry, question))
    return std::nullopt;
  shares_.resize(question.luxels.size());
  const auto answer = static_cast<Answer>(entry->tag & kAnswerBits);
  for (std::size_t i = 0; i < shares_.size(); ++i) shares_[i] = find_share(answer, entry->answer, i);
  return shares_;
}

}  // namespace temblor::compiler
