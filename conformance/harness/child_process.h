// A program of its own with pipes to it: how drivers are kept apart from each other and from the suite.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <sys/types.h>

namespace gouraud::conformance {

struct Command {
  std::string program;  ///< path
  std::vector<std::string> arguments;
  std::vector<std::pair<std::string, std::string>> environment;  ///< set in the child, over what it inherits
  std::vector<std::string> dropped_environment;                  ///< prefixes of variables that it does not inherit
  bool quiet = false;                                            ///< its stdout and stderr go nowhere
};

/// File descriptors of the child's two pipes: what it writes to us and what it reads from us.
inline constexpr int child_output_fd = 3;
inline constexpr int child_input_fd = 4;

/// A running child. Destruction kills it if it still runs.
class ChildProcess {
 public:
  /// Starts the command; throws std::runtime_error if it cannot.
  explicit ChildProcess(const Command& command);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  int read_fd() const { return read_fd_; }
  int write_fd() const { return write_fd_; }
  void kill();

  /// Waits for its end and says how it ended: empty for exit status 0, else "signal 11 (Segmentation fault)",
  /// "exit status 1".
  std::string wait();

 private:
  pid_t pid_ = -1;
  int read_fd_ = -1, write_fd_ = -1;
};

}  // namespace gouraud::conformance
