#include "app/files/child_process.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdio>
#include <system_error>
#include <thread>
#include <utility>

#include "base/text.h"

extern char** environ;

namespace temblor::app {
namespace {

using base::ErrorCode;

base::Error system_error(const char* what, int code) {
  return base::error(ErrorCode::kIo, "{}: {}", what, std::generic_category().message(code));
}

// While it exists, a write to a pipe without a reader fails with EPIPE instead of killing this process.
class IgnoreBrokenPipe {
 public:
  IgnoreBrokenPipe() { previous_ = signal(SIGPIPE, SIG_IGN); }
  ~IgnoreBrokenPipe() { signal(SIGPIPE, previous_); }
  IgnoreBrokenPipe(const IgnoreBrokenPipe&) = delete;
  IgnoreBrokenPipe& operator=(const IgnoreBrokenPipe&) = delete;

 private:
  void (*previous_)(int);
};

// Opens a temporary file without a name, which is gone when it is closed. Returns -1 on failure.
int open_unnamed_file() {
  std::FILE* file = std::tmpfile();
  if (file == nullptr) return -1;
  const int copy = fcntl(fileno(file), F_DUPFD_CLOEXEC, 3);
  std::fclose(file);
  return copy;
}

// Sets the attributes of a program in a separate session. Signals that we block, because a thread waits for
// them, must still end it.
void request_separate_session(posix_spawnattr_t& io_attributes) {
  sigset_t none;
  sigemptyset(&none);
  posix_spawnattr_setsigmask(&io_attributes, &none);
  posix_spawnattr_setflags(&io_attributes, POSIX_SPAWN_SETSID | POSIX_SPAWN_SETSIGMASK);
}

// Starts the program with `pipe_end` as standard input and `messages` as standard output and error. Returns 0
// or an errno value.
int spawn(const std::vector<std::string>& words, ChildSession session, int pipe_end, int messages,
          pid_t& out_process) {
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, pipe_end, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, messages, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, messages, STDERR_FILENO);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  if (session == ChildSession::kSeparate) request_separate_session(attributes);
  const int failure =
      posix_spawnp(&out_process, arguments[0], &actions, &attributes, arguments.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  return failure;
}

}  // namespace

// O_CLOEXEC keeps the parent's end of the pipe from the child, which otherwise would never see the end of its
// input.
base::Result<ChildProcess> ChildProcess::start(const std::vector<std::string>& words, ChildSession session) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) return system_error("pipe", errno);
  const int messages = open_unnamed_file();
  pid_t process = -1;
  const int failure = messages < 0 ? errno : spawn(words, session, ends[0], messages, process);
  close(ends[0]);
  if (failure == 0)
    return ChildProcess(words[0], process, session == ChildSession::kSeparate ? process : -1, ends[1],
                        messages);
  close(ends[1]);
  if (messages >= 0) close(messages);
  if (failure == ENOENT) return base::error(ErrorCode::kNotFound, "the program {} is not in PATH", words[0]);
  return system_error(words[0].c_str(), failure);
}

ChildProcess::~ChildProcess() {
  close_input();
  end_session();
  if (process_ >= 0 && !status_) {
    terminate();
    waitpid(process_, nullptr, 0);
  }
  if (messages_ >= 0) close(messages_);
}

ChildProcess::ChildProcess(ChildProcess&& other) noexcept
    : name_(std::move(other.name_)),
      process_(std::exchange(other.process_, -1)),
      session_(std::exchange(other.session_, -1)),
      status_(std::exchange(other.status_, std::nullopt)),
      input_(std::exchange(other.input_, -1)),
      messages_(std::exchange(other.messages_, -1)) {}

ChildProcess& ChildProcess::operator=(ChildProcess&& other) noexcept {
  std::swap(name_, other.name_);
  std::swap(process_, other.process_);
  std::swap(session_, other.session_);
  std::swap(status_, other.status_);
  std::swap(input_, other.input_);
  std::swap(messages_, other.messages_);
  return *this;
}

void ChildProcess::close_input() {
  if (input_ >= 0) close(std::exchange(input_, -1));
}

std::size_t ChildProcess::output_size() const {
  struct stat status {};
  return fstat(messages_, &status) == 0 ? static_cast<std::size_t>(status.st_size) : 0;
}

// Returns the end of the output file. Both processes share its position, so read with pread(), which does not
// move it.
std::string ChildProcess::output(std::size_t max_bytes) const {
  const std::size_t size = output_size();
  std::string text(std::min(size, max_bytes), '\0');
  const ssize_t count = pread(messages_, text.data(), text.size(), static_cast<off_t>(size - text.size()));
  text.resize(static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
  return text;
}

std::vector<std::string> ChildProcess::messages() const {
  constexpr std::size_t kMaxBytes = 4096;
  std::vector<std::string> lines;
  std::string line;
  for (const char c : output(kMaxBytes) + '\n') {
    if (c != '\n' && c != '\r')
      line += c;
    else if (!line.empty())
      lines.push_back(base::printable(std::exchange(line, {})));
  }
  return lines;
}

// If the program has ended, finish() knows its error message, which says more than "broken pipe".
base::Status ChildProcess::write(base::Bytes bytes) {
  const IgnoreBrokenPipe ignore;
  while (!bytes.empty()) {
    const ssize_t written = ::write(input_, bytes.data(), bytes.size());
    if (written >= 0) {
      bytes = bytes.subspan(static_cast<std::size_t>(written));
    } else if (errno != EINTR) {
      const int failure = errno;
      TRY_STATUS(finish());
      return system_error(name_.c_str(), failure);
    }
  }
  return base::Ok{};
}

bool ChildProcess::has_ended() {
  if (process_ < 0 || status_) return true;
  int status = 0;
  if (waitpid(process_, &status, WNOHANG) == process_) status_ = status;
  return status_.has_value();
}

void ChildProcess::terminate() {
  if (process_ >= 0 && !status_) kill(process_, SIGTERM);
}

void ChildProcess::lower_priority() {
  constexpr int kNiceness = 10;
  if (process_ >= 0 && !status_) setpriority(PRIO_PROCESS, static_cast<id_t>(process_), kNiceness);
}

// The processes get a second to end by themselves. A session keeps its id while it has processes, so no other
// program can have this id.
void ChildProcess::end_session() {
  if (session_ < 0) return;
  // has_ended() removes the first process, which would count otherwise.
  const auto has_processes = [this] {
    has_ended();
    return kill(-session_, 0) == 0;
  };
  kill(-session_, SIGTERM);
  for (int i = 0; i < 100 && has_processes(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  if (has_processes()) kill(-session_, SIGKILL);
  session_ = -1;
}

base::Result<int> ChildProcess::wait() {
  close_input();
  int status = status_.value_or(0);
  while (!status_ && waitpid(process_, &status, 0) < 0)
    if (errno != EINTR) return system_error(name_.c_str(), errno);
  process_ = -1;
  constexpr int kSignalStatusBase = 128;
  return WIFEXITED(status) ? WEXITSTATUS(status) : kSignalStatusBase + WTERMSIG(status);
}

// Closing the input tells filters such as ffmpeg that no more frames follow, so they write the end of the
// file and exit.
base::Status ChildProcess::finish() {
  if (process_ < 0) return base::Ok{};
  TRY(const int status, wait());
  if (status == 0) return base::Ok{};
  const std::vector<std::string> said = messages();
  std::string message = said.empty() ? std::string() : said.back();
  // Temblor prefixes its own errors with its name, which the message below already has.
  if (const std::string own = name_ + ": "; message.starts_with(own)) message.erase(0, own.size());
  return base::error(ErrorCode::kIo, "{} failed: {}", name_, message.empty() ? "no error message" : message);
}

}  // namespace temblor::app
