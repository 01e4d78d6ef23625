// DP_QC_STRINGBUFFERS: lists of strings. A wrong handle prints a warning, as in engines that have them.
#include <algorithm>

#include "builtins/families/families.h"

namespace temblor::builtins {
namespace {

constexpr std::size_t kMaxBuffers = 1024, kMaxStrings = 65536;
constexpr std::size_t kMaxBufferChars = std::size_t{1} << 20;  // of one string

using Strings = std::vector<std::string>;

// Null, after a warning, if there is no such buffer.
Strings* find_buffer(Call& io_call, int parameter) {
  const auto found = io_call.context.buffers.find(io_call.whole(parameter));
  if (found != io_call.context.buffers.end()) return &found->second;
  io_call.warn_once(fmt::format("{} is not a string buffer", io_call.whole(parameter)));
  return nullptr;
}

// buf_create(): returns a handle, or -1.
base::Status buf_create(Call& io_call) {
  StringBuffers& buffers = io_call.context.buffers;
  if (buffers.size() >= kMaxBuffers) return io_call.return_number(-1);
  int handle = 0;
  while (buffers.contains(handle)) ++handle;
  buffers[handle];
  return io_call.return_number(handle);
}
base::Status buf_del(Call& io_call) {
  if (find_buffer(io_call, 0) != nullptr) io_call.context.buffers.erase(io_call.whole(0));
  return base::Ok{};
}
base::Status buf_getsize(Call& io_call) {
  const Strings* const strings = find_buffer(io_call, 0);
  return io_call.return_number(strings == nullptr ? -1 : static_cast<double>(strings->size()));
}
// buf_copy(from, to)
base::Status buf_copy(Call& io_call) {
  const Strings* const from = find_buffer(io_call, 0);
  Strings* const to = find_buffer(io_call, 1);
  if (from == nullptr || to == nullptr || from == to) return base::Ok{};
  io_call.machine.charge(from->size());
  *to = *from;
  return base::Ok{};
}
// buf_sort(handle, compared_characters, is_descending): 0 characters compare whole strings.
base::Status buf_sort(Call& io_call) {
  Strings* const strings = find_buffer(io_call, 0);
  if (strings == nullptr) return base::Ok{};
  const int limit = io_call.whole(1);
  const std::size_t chars = limit > 0 ? static_cast<std::size_t>(limit) : std::string::npos;
  io_call.machine.charge(strings->size() * 16);
  std::stable_sort(strings->begin(), strings->end(), [&](const std::string& a, const std::string& b) {
    return std::string_view(a).substr(0, chars) < std::string_view(b).substr(0, chars);
  });
  if (io_call.number(2) != 0) std::reverse(strings->begin(), strings->end());
  return base::Ok{};
}
// buf_implode(handle, glue): all strings, joined.
base::Status buf_implode(Call& io_call) {
  std::string joined;
  if (const Strings* const strings = find_buffer(io_call, 0))
    for (const std::string& string : *strings) {
      if (!joined.empty()) joined += io_call.text(1);
      joined += string;
      if (joined.size() > kMaxBufferChars)
        return io_call.error("the result is longer than {} characters", kMaxBufferChars);
    }
  io_call.machine.charge(joined.size() / 16);
  return io_call.return_text(joined);
}
// bufstr_get(handle, index): empty if there is no such string.
base::Status bufstr_get(Call& io_call) {
  const Strings* const strings = find_buffer(io_call, 0);
  const int i = io_call.whole(1);
  const bool is_there = strings != nullptr && i >= 0 && static_cast<std::size_t>(i) < strings->size();
  return io_call.return_text(is_there ? std::string_view((*strings)[static_cast<std::size_t>(i)]) : "");
}
base::Status set_string(Call& io_call, Strings& io_strings, int i, std::string_view text) {
  if (i < 0 || static_cast<std::size_t>(i) >= kMaxStrings)
    return io_call.error("index {} is not 0 to {}", i, kMaxStrings - 1);
  const auto place = static_cast<std::size_t>(i);
  io_call.machine.charge(text.size() / 16 + (place >= io_strings.size() ? place - io_strings.size() : 0));
  if (place >= io_strings.size()) io_strings.resize(place + 1);
  io_strings[place] = text;
  return base::Ok{};
}
base::Status bufstr_set(Call& io_call) {
  Strings* const strings = find_buffer(io_call, 0);
  return strings == nullptr ? base::Status(base::Ok{})
                            : set_string(io_call, *strings, io_call.whole(1), io_call.text(2));
}
// bufstr_add(handle, text, order): appends it if `order` is not 0, else puts it into the first empty place.
// Returns its index.
base::Status bufstr_add(Call& io_call) {
  Strings* const strings = find_buffer(io_call, 0);
  if (strings == nullptr) return io_call.return_number(-1);
  auto place = strings->end();
  if (io_call.number(2) == 0)
    place = std::find_if(strings->begin(), strings->end(), [](const std::string& s) { return s.empty(); });
  const int i = static_cast<int>(place - strings->begin());
  TRY_STATUS(set_string(io_call, *strings, i, io_call.text(1)));
  return io_call.return_number(i);
}
base::Status bufstr_free(Call& io_call) {
  Strings* const strings = find_buffer(io_call, 0);
  const int i = io_call.whole(1);
  if (strings == nullptr || i < 0 || static_cast<std::size_t>(i) >= strings->size()) return base::Ok{};
  (*strings)[static_cast<std::size_t>(i)].clear();
  while (!strings->empty() && strings->back().empty()) strings->pop_back();
  return base::Ok{};
}

}  // namespace

std::span<const Entry> buffer_builtins() {
  static constexpr Entry kEntries[] = {
      {460, "buf_create", buf_create},   {461, "buf_del", buf_del},       {462, "buf_getsize", buf_getsize},
      {463, "buf_copy", buf_copy},       {464, "buf_sort", buf_sort},     {465, "buf_implode", buf_implode},
      {466, "bufstr_get", bufstr_get},   {467, "bufstr_set", bufstr_set}, {468, "bufstr_add", bufstr_add},
      {469, "bufstr_free", bufstr_free},
  };
  return kEntries;
}

}  // namespace temblor::builtins
