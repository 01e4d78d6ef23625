// FRIK_FILE: text files of the program's own.
#include "server/builtins/families.h"

namespace temblor::server {
namespace {

// A file that is not open, or not open that way, is the program's mistake.
base::Error misuse(Call& io_call, const base::Error& error) {
  return io_call.error("{}", error.message());
}

// fopen(name, mode): a handle, or -1.
base::Status fopen(Call& io_call) {
  const float mode = io_call.number(1);
  if (mode != 0 && mode != 1 && mode != 2) return io_call.error("mode {} is none of 0, 1 and 2", mode);
  const base::Result<int> handle =
      io_call.game.files.open(io_call.text(0), static_cast<ScriptFileMode>(to_whole(mode)));
  // A file to read may well not be there; everything else is worth a word.
  if (!handle.ok() && handle.error().code != base::ErrorCode::kNotFound)
    io_call.warn_once(handle.error().message());
  io_call.machine.return_float(handle.ok() ? static_cast<float>(*handle) : -1);
  return base::Ok{};
}

base::Status fclose(Call& io_call) {
  const base::Status closed = io_call.game.files.close(io_call.whole(0));
  if (closed.ok()) return closed;
  if (closed.error().code == base::ErrorCode::kUsage) return misuse(io_call, closed.error());
  io_call.warn_once(closed.error().message());
  return base::Ok{};
}

// The empty string at the end of the file, as for an empty line.
base::Status fgets(Call& io_call) {
  const auto line = io_call.game.files.read_line(io_call.whole(0));
  if (!line.ok()) return misuse(io_call, line.error());
  if (line->has_value()) return io_call.return_text(**line);
  io_call.machine.return_string(vm::kEmptyString);
  return base::Ok{};
}

base::Status fputs(Call& io_call) {
  const base::Status written = io_call.game.files.write(io_call.whole(0), io_call.joined_text(1));
  if (written.ok()) return written;
  if (written.error().code == base::ErrorCode::kUsage) return misuse(io_call, written.error());
  io_call.warn_once(written.error().message());
  return base::Ok{};
}

// whichpack(name): where a file of the game lies; empty where there is none.
base::Status whichpack(Call& io_call) {
  return io_call.return_text(io_call.game.pack_of ? io_call.game.pack_of(io_call.text(0)) : std::string());
}

}  // namespace

std::span<const BuiltinEntry> file_builtins() {
  static constexpr BuiltinEntry kEntries[] = {
      {110, "fopen", fopen}, {111, "fclose", fclose},       {112, "fgets", fgets},
      {113, "fputs", fputs}, {503, "whichpack", whichpack},
  };
  return kEntries;
}

}  // namespace temblor::server
