#include "builtins/script_files.h"

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <iterator>
#include <system_error>

#include "base/text.h"

namespace temblor::builtins {
namespace {

using base::ErrorCode;

constexpr std::string_view kFolder = "data/";
// Text is collected, and written when there is this much, so that game code may write a byte at a time.
constexpr std::size_t kFlushBytes = std::size_t{1} << 16;

// Characters that are safe in file names on all platforms, without the backslash and the colon.
bool is_name_character(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
         std::string_view("_-+=. /()[]!#$@,~").find(c) != std::string_view::npos;
}

// The name of a folder or file. Leading dots would allow ".." and hidden files; Windows drops trailing dots
// and blanks.
bool is_part_of_a_name(std::string_view part) {
  return !part.empty() && part.front() != '.' && part.front() != ' ' && part.back() != ' ' &&
         part.back() != '.' && std::all_of(part.begin(), part.end(), is_name_character);
}

// The name relative to data/, if it is allowed.
base::Result<std::string> checked_name(std::string_view name) {
  const auto refuse = [&](const char* why) {
    return base::error(ErrorCode::kUsage, "the file name \"{}\" {}", base::quotable(name), why);
  };
  std::string_view rest = name;
  if (rest.starts_with(kFolder)) rest.remove_prefix(kFolder.size());
  if (rest.size() > ScriptFiles::kMaxNameChars) return refuse("is too long");
  for (std::size_t begin = 0; begin <= rest.size();) {
    const std::size_t end = std::min(rest.find('/', begin), rest.size());
    if (!is_part_of_a_name(rest.substr(begin, end - begin)))
      return refuse("is not a plain name below the data folder");
    begin = end + 1;
  }
  return std::string(rest);
}

// Empty if the file does not exist, cannot be read, or is too large.
std::optional<std::string> read_disk(const std::filesystem::path& path) {
  std::error_code error;
  const auto size = std::filesystem::file_size(path, error);
  if (error || size > ScriptFiles::kMaxFileBytes) return std::nullopt;
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return std::nullopt;
  std::string text(size, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(size));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return text;
}

base::Error cannot_write(const std::filesystem::path& path, const std::string& reason) {
  return base::error(ErrorCode::kIo, "{}: cannot write ({})", path.string(), reason);
}

}  // namespace

base::Result<ScriptFiles::File*> ScriptFiles::find(int handle) {
  if (handle < 0 || handle >= kMaxOpen || !files_[static_cast<std::size_t>(handle)])
    return base::error(ErrorCode::kUsage, "file {} is not open", handle);
  return &*files_[static_cast<std::size_t>(handle)];
}

// A file that game code has written takes precedence over one that came with the game.
base::Result<std::string> ScriptFiles::read_all(const std::string& name) const {
  if (!data_folder_.empty())
    if (std::optional<std::string> text = read_disk(data_folder_ / name)) return *std::move(text);
  if (!reader_) return base::error(ErrorCode::kNotFound, "there is no file data/{}", name);
  TRY(const base::ByteVector bytes, reader_(std::string(kFolder) + name));
  if (bytes.size() > kMaxFileBytes)
    return base::error(ErrorCode::kTooLarge, "data/{} has {} bytes; the limit is {}", name, bytes.size(),
                       kMaxFileBytes);
  return std::string(base::as_text(bytes));
}

base::Result<int> ScriptFiles::open(std::string_view name, ScriptFileMode mode) {
  TRY(const std::string inside, checked_name(name));
  const auto place = std::find(files_.begin(), files_.end(), std::nullopt);
  if (place == files_.end()) return base::error(ErrorCode::kTooLarge, "{} files are open already", kMaxOpen);
  File file{.mode = mode};
  if (mode == ScriptFileMode::kRead) {
    TRY(file.text, read_all(inside));
  } else {
    if (!can_write()) return base::error(ErrorCode::kUsage, "there is no folder to write data/{} to", inside);
    file.path = data_folder_ / inside;
    std::error_code error;
    std::filesystem::create_directories(file.path.parent_path(), error);
    if (error) return cannot_write(file.path, error.message());
    const auto flags = mode == ScriptFileMode::kAppend ? std::ios::app : std::ios::trunc;
    errno = 0;
    if (!std::ofstream(file.path, std::ios::binary | flags))
      return cannot_write(file.path, std::generic_category().message(errno));
    const auto size = std::filesystem::file_size(file.path, error);
    if (!error) file.at = static_cast<std::size_t>(size);
  }
  *place = std::move(file);
  return static_cast<int>(place - files_.begin());
}

// The file is opened for each flush only, so that it can be read from outside while the game runs.
base::Status ScriptFiles::flush(File& io_file) {
  if (io_file.mode == ScriptFileMode::kRead || io_file.text.empty()) return base::Ok{};
  errno = 0;
  std::ofstream stream(io_file.path, std::ios::binary | std::ios::app);
  stream << io_file.text << std::flush;
  io_file.at += io_file.text.size();
  io_file.text.clear();
  if (!stream) return cannot_write(io_file.path, std::generic_category().message(errno));
  return base::Ok{};
}

base::Status ScriptFiles::close(int handle) {
  TRY(File* const file, find(handle));
  base::Status status = flush(*file);
  files_[static_cast<std::size_t>(handle)].reset();
  return status;
}

// Accepts both kinds of line ends. A line ends at a zero byte, too, because QuakeC's strings do.
base::Result<std::optional<std::string_view>> ScriptFiles::read_line(int handle) {
  TRY(File* const file, find(handle));
  if (file->mode != ScriptFileMode::kRead)
    return base::error(ErrorCode::kUsage, "file {} is open for writing", handle);
  if (file->at >= file->text.size()) return std::optional<std::string_view>{};
  const std::string_view rest = std::string_view(file->text).substr(file->at);
  const std::size_t size = std::min(rest.find('\n'), rest.size());
  file->at += size + 1;
  std::string_view line = rest.substr(0, size);
  if (line.ends_with('\r')) line.remove_suffix(1);
  return std::optional(line.substr(0, line.find('\0')));
}

base::Status ScriptFiles::write(int handle, std::string_view text) {
  TRY(File* const file, find(handle));
  if (file->mode == ScriptFileMode::kRead)
    return base::error(ErrorCode::kUsage, "file {} is open for reading", handle);
  const std::size_t size = file->at + file->text.size();
  if (size > kMaxFileBytes || text.size() > kMaxFileBytes - size)
    return base::error(ErrorCode::kTooLarge, "the file would exceed {} bytes", kMaxFileBytes);
  if (text.size() > kMaxWrittenBytes - written_bytes_)
    return base::error(ErrorCode::kTooLarge, "this game has written {} bytes; no more is allowed",
                       written_bytes_);
  written_bytes_ += text.size();
  file->text += text;
  if (file->text.size() < kFlushBytes) return base::Ok{};
  return flush(*file);
}

base::Status ScriptFiles::close_all() {
  base::Status first = base::Ok{};
  for (std::optional<File>& file : files_) {
    if (!file) continue;
    base::Status written = flush(*file);
    if (first.ok()) first = std::move(written);
    file.reset();
  }
  return first;
}

}  // namespace temblor::builtins
