// Another program that is fed through a pipe (ffmpeg). POSIX.
#pragma once

#include <string>
#include <vector>

#include "base/bytes.h"
#include "base/result.h"

namespace temblor::app {

// Runs until finish(), or is ended when it is destroyed before.
class ChildProcess {
 public:
  // words[0] is looked for in PATH. kNotFound when there is no such program.
  static base::Result<ChildProcess> start(const std::vector<std::string>& words);
  ~ChildProcess();
  ChildProcess(ChildProcess&& other) noexcept;
  ChildProcess& operator=(ChildProcess&& other) noexcept;

  // To its standard input. Fails when it has ended; the error then says what it said.
  base::Status write(base::Bytes bytes);
  // Ends its input and waits for it. Fails unless its exit status is 0; the error has the last line that it
  // wrote to standard error. Nothing is left to say once it has been waited for, here or in write().
  base::Status finish();
  // The last lines that it has written to standard error until now.
  std::vector<std::string> messages() const;

 private:
  ChildProcess(std::string name, int process, int input, int messages)
      : name_(std::move(name)), process_(process), input_(input), messages_(messages) {}
  void close_input();
  std::string message_text() const;

  std::string name_;
  int process_ = -1;   // -1: has ended
  int input_ = -1;     // file descriptors; -1: closed
  int messages_ = -1;  // a file without a name that takes its standard error
};

}  // namespace temblor::app
