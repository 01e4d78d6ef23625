// Runs another program (POSIX): ffmpeg, which receives frames through a pipe, the compiler, or a shell
// command.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/bytes.h"
#include "base/result.h"

namespace temblor::app {

// Decides which signals reach a program, and what it leaves behind.
enum class ChildSession {
  // The terminal is shared, and Ctrl-C ends both programs.
  kShared,
  // A new session without a terminal. Ctrl-C does not reach it, and no process of it survives ChildProcess.
  kSeparate,
};

// A running program. Output and errors go to one temporary file without a name, so that the child never
// blocks on a full pipe. The destructor terminates a program that finish() has not waited for.
class ChildProcess {
 public:
  // Starts words[0], which is searched in PATH. kNotFound if there is no such program.
  static base::Result<ChildProcess> start(const std::vector<std::string>& words,
                                          ChildSession session = ChildSession::kShared);
  ~ChildProcess();
  ChildProcess(ChildProcess&& other) noexcept;
  ChildProcess& operator=(ChildProcess&& other) noexcept;

  // Writes to its standard input. Fails if the program has ended; the error has the program's last message.
  base::Status write(base::Bytes bytes);
  // Ends its standard input, as at the end of a file.
  void close_input();
  // Closes its input and waits for it to end. Returns its exit status; after a signal, 128 plus the signal's
  // number, as shells do. Call it only once, and not after finish().
  base::Result<int> wait();
  // Closes its input and waits for it to end. Fails unless its exit status is 0; the error has the last line
  // that it printed. After a failed write() it returns success, because that error was already reported.
  base::Status finish();
  // Returns whether it has ended, without waiting. Then finish() returns at once.
  bool has_ended();
  // Asks it to end (SIGTERM), without waiting.
  void terminate();
  // Lets other programs have the processor first.
  void lower_priority();
  // The lines that it has printed so far; only those in the last 4 KiB.
  std::vector<std::string> messages() const;
  // Everything that it has printed so far; at most the last `max_bytes` of it.
  std::string output(std::size_t max_bytes) const;
  std::size_t output_size() const;

 private:
  ChildProcess(std::string name, int process, int session, int input, int messages)
      : name_(std::move(name)), process_(process), session_(session), input_(input), messages_(messages) {}
  void end_session();

  std::string name_;
  // Process id; -1: it has ended.
  int process_ = -1;
  // Id of its separate session; -1: it shares ours.
  int session_ = -1;
  // Its status for waitpid(), once has_ended().
  std::optional<int> status_{};
  // File descriptors: the write end of the pipe to its standard input (-1: closed), and the file with its
  // output.
  int input_ = -1, messages_ = -1;
};

}  // namespace temblor::app
