// FRIK_FILE: built-in functions for text files of game code (script_files.h). A mistake in a call ends
// the game; a failure of the disk prints a warning.
#include "builtins/families/families.h"

namespace temblor::builtins {
namespace {

// For a file that is not open, or open the other way.
base::Error misuse(Call& io_call, const base::Error& error) {
  return io_call.error("{}", error.message());
}

// fopen(name, mode): opens a file and returns its handle, or -1.
base::Status fopen(Call& io_call) {
  const float mode = io_call.number(1);
  if (mode != 0 && mode != 1 && mode != 2)
    return io_call.error("mode {} is not 0 (read), 1 (append) or 2 (write)", mode);
  const base::Result<int> handle =
      io_call.context.files.open(io_call.text(0), static_cast<ScriptFileMode>(to_whole(mode)));
  // It is normal that a file to read does not exist. Print every other error.
  if (!handle.ok() && handle.error().code != base::ErrorCode::kNotFound)
    io_call.warn_once(handle.error().message());
  io_call.machine.return_float(handle.ok() ? static_cast<float>(*handle) : -1);
  return base::Ok{};
}

// fclose(handle)
base::Status fclose(Call& io_call) {
  const base::Status closed = io_call.context.files.close(io_call.whole(0));
  if (closed.ok()) return closed;
  if (closed.error().code == base::ErrorCode::kUsage) return misuse(io_call, closed.error());
  io_call.warn_once(closed.error().message());
  return base::Ok{};
}

// fgets(handle): the next line without its newline. At the end of the file it returns the empty string, as
// for an empty line.
base::Status fgets(Call& io_call) {
  const auto line = io_call.context.files.read_line(io_call.whole(0));
  if (!line.ok()) return misuse(io_call, line.error());
  if (line->has_value()) return io_call.return_text(**line);
  io_call.machine.return_string(vm::kEmptyString);
  return base::Ok{};
}

// fputs(handle, text, ...)
base::Status fputs(Call& io_call) {
  const base::Status written = io_call.context.files.write(io_call.whole(0), io_call.joined_text(1));
  if (written.ok()) return written;
  if (written.error().code == base::ErrorCode::kUsage) return misuse(io_call, written.error());
  io_call.warn_once(written.error().message());
  return base::Ok{};
}

// whichpack(name): the archive or folder that a file of the game is in; empty if there is no such file.
base::Status whichpack(Call& io_call) {
  return io_call.return_text(io_call.context.find_pack ? io_call.context.find_pack(io_call.text(0))
                                                       : std::string());
}

}  // namespace

std::span<const Entry> file_builtins() {
  static constexpr Entry kEntries[] = {
      {110, "fopen", fopen}, {111, "fclose", fclose},       {112, "fgets", fgets},
      {113, "fputs", fputs}, {503, "whichpack", whichpack},
  };
  return kEntries;
}

}  // namespace temblor::builtins
