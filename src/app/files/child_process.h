// Runs another program (POSIX): ffmpeg, which receives frames through a pipe, or the compiler.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/bytes.h"
#include "base/result.h"

namespace temblor::app {

// A running program. Output and errors go to one temporary file without a name, so that the child never
// blocks on a full pipe. The destructor terminates a program that finish() has not waited for.
class ChildProcess {
 public:
  // Starts words[0], which is searched in PATH. kNotFound if there is no such program.
  static base::Result<ChildProcess> start(const std::vector<std::string>& words);
  ~ChildProcess();
  ChildProcess(ChildProcess&& other) noexcept;
  ChildProcess& operator=(ChildProcess&& other) noexcept;

  // Writes to its standard input. Fails if the program has ended; the error has the program's last message.
  base::Status write(base::Bytes bytes);
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

 private:
  ChildProcess(std::string name, int process, int input, int messages)
      : name_(std::move(name)), process_(process), input_(input), messages_(messages) {}
  void close_input();
  std::string message_text() const;

  std::string name_;
  // Process id; -1: it has ended.
  int process_ = -1;
  // Its status for waitpid(), once has_ended().
  std::optional<int> status_{};
  // File descriptors: the write end of the pipe to its standard input (-1: closed), and the file with its
  // output.
  int input_ = -1, messages_ = -1;
};

}  // namespace temblor::app
