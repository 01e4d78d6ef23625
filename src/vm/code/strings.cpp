#include "vm/code/strings.h"

#include <algorithm>
#include <utility>

namespace temblor::vm {
namespace {

constexpr std::uint32_t kFirstMade = 0x8000'0001;
constexpr std::size_t kOverheadBytes = 96;  // approximate bookkeeping for each string
constexpr std::size_t kBytesBetweenCollections = 1 << 20;

std::size_t memory_bytes(std::string_view text) {
  return text.size() + kOverheadBytes;
}

}  // namespace

Strings::Strings(std::string_view program_strings, std::size_t limit_bytes)
    : program_(program_strings), limit_bytes_(limit_bytes) {
  CHECK(!program_.empty() && program_.front() == '\0' && program_.back() == '\0');
}

const Strings::Slot* Strings::find_slot(StringIndex index) const {
  const auto number = static_cast<std::uint32_t>(index);
  if (number < kFirstMade || number - kFirstMade >= slots_.size()) return nullptr;
  const Slot& slot = slots_[number - kFirstMade];
  return slot.text ? &slot : nullptr;
}

bool Strings::contains(StringIndex index) const {
  return base::to_size(index) < program_.size() || find_slot(index) != nullptr;
}

std::string_view Strings::text(StringIndex index) const {
  if (base::to_size(index) < program_.size()) return program_.data() + base::to_size(index);
  const Slot* slot = find_slot(index);
  return slot != nullptr ? std::string_view(*slot->text) : std::string_view();
}

bool Strings::is_empty(StringIndex index) const {
  if (base::to_size(index) < program_.size()) return program_[base::to_size(index)] == '\0';
  return find_slot(index) == nullptr;  // a made string is never empty
}

base::Result<StringIndex> Strings::make(std::string_view text) {
  text = text.substr(0, text.find('\0'));
  if (text.empty()) return kEmptyString;
  if (bytes_ + memory_bytes(text) > limit_bytes_)
    return base::error(base::ErrorCode::kTooLarge,
                       "out of string memory: {} strings use {} bytes; the limit is {}", made_count(), bytes_,
                       limit_bytes_);
  if (free_.empty()) {
    free_.push_back(static_cast<std::uint32_t>(slots_.size()));
    slots_.emplace_back();
  }
  const std::uint32_t number = free_.back();
  slots_[number].text = std::make_unique<const std::string>(text);
  free_.pop_back();
  bytes_ += memory_bytes(text);
  bytes_since_collection_ += memory_bytes(text);
  return StringIndex{kFirstMade + number};
}

base::Result<StringIndex> Strings::zone(std::string_view text) {
  TRY(const StringIndex index, make(text));
  if (index != kEmptyString) slots_[static_cast<std::uint32_t>(index) - kFirstMade].is_zoned = true;
  return index;
}

bool Strings::unzone(StringIndex index) {
  if (find_slot(index) == nullptr) return false;
  return std::exchange(slots_[static_cast<std::uint32_t>(index) - kFirstMade].is_zoned, false);
}

bool Strings::needs_collection() const {
  return bytes_since_collection_ > std::min(kBytesBetweenCollections, limit_bytes_ / 4);
}

// Mark and sweep. A word that only looks like the number of a string keeps it alive, which is harmless.
void Strings::collect(std::initializer_list<std::span<const std::uint32_t>> holders) {
  for (Slot& slot : slots_) slot.is_held = slot.is_zoned;
  for (const std::span<const std::uint32_t> words : holders)
    for (const std::uint32_t word : words)
      if (word >= kFirstMade && word - kFirstMade < slots_.size()) slots_[word - kFirstMade].is_held = true;
  for (std::uint32_t i = 0; i < slots_.size(); ++i) {
    Slot& slot = slots_[i];
    if (slot.is_held || !slot.text) continue;
    bytes_ -= memory_bytes(*slot.text);
    slot.text = nullptr;
    free_.push_back(i);
  }
  bytes_since_collection_ = 0;
}

}  // namespace temblor::vm
