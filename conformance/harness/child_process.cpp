#include "conformance/harness/child_process.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <stdexcept>
#include <string_view>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace gouraud::conformance {
namespace {

struct Pipe {
  int read_end = -1, write_end = -1;
};

/// Close-on-exec, so that no child holds another's pipe open; above the two numbers that children get.
Pipe make_pipe() {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error(std::string("pipe: ") + std::strerror(errno));
  Pipe pipe;
  for (int i = 0; i < 2; ++i) {
    const int moved = ::fcntl(ends[i], F_DUPFD_CLOEXEC, child_input_fd + 1);
    ::close(ends[i]);
    (i == 0 ? pipe.read_end : pipe.write_end) = moved;
  }
  return pipe;
}

std::vector<std::string> environment_of(const Command& command) {
  std::vector<std::string> result;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string_view text(*entry);
    const std::string_view name = text.substr(0, text.find('='));
    const bool dropped = std::ranges::any_of(command.dropped_environment,
                                             [&](const std::string& prefix) { return name.starts_with(prefix); });
    const bool replaced = std::ranges::any_of(command.environment, [&](const auto& set) { return set.first == name; });
    if (!dropped && !replaced) result.emplace_back(text);
  }
  for (const auto& [name, value] : command.environment) result.push_back(name + "=" + value);
  return result;
}

std::vector<char*> pointers(std::vector<std::string>& strings) {
  std::vector<char*> result;
  for (std::string& text : strings) result.push_back(text.data());
  result.push_back(nullptr);
  return result;
}

}  // namespace

ChildProcess::ChildProcess(const Command& command) {
  const Pipe from_child = make_pipe();
  const Pipe to_child = make_pipe();

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, from_child.write_end, child_output_fd);
  posix_spawn_file_actions_adddup2(&actions, to_child.read_end, child_input_fd);
  if (command.quiet) {
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  }

  std::vector<std::string> arguments{command.program};
  arguments.insert(arguments.end(), command.arguments.begin(), command.arguments.end());
  std::vector<std::string> environment = environment_of(command);
  const int error = ::posix_spawn(&pid_, command.program.c_str(), &actions, nullptr, pointers(arguments).data(),
                                  pointers(environment).data());
  posix_spawn_file_actions_destroy(&actions);
  ::close(from_child.write_end);
  ::close(to_child.read_end);
  read_fd_ = from_child.read_end;
  write_fd_ = to_child.write_end;
  if (error != 0) {
    ::close(read_fd_);
    ::close(write_fd_);
    throw std::runtime_error("cannot start " + command.program + ": " + std::strerror(error));
  }
}

ChildProcess::~ChildProcess() {
  ::close(read_fd_);
  ::close(write_fd_);
  if (pid_ > 0) {
    kill();
    wait();
  }
}

void ChildProcess::kill() {
  if (pid_ > 0) ::kill(pid_, SIGKILL);
}

std::string ChildProcess::wait() {
  int status = 0;
  while (::waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
  }
  pid_ = -1;
  if (WIFSIGNALED(status)) {
    const int signal = WTERMSIG(status);
    return "signal " + std::to_string(signal) + " (" + ::strsignal(signal) + ")";
  }
  const int code = WEXITSTATUS(status);
  return code == 0 ? "" : "exit status " + std::to_string(code);
}

}  // namespace gouraud::conformance
