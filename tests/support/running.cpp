#include "tests/support/running.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <system_error>

extern char**
    environ;  // NOLINT(readability-redundant-declaration): POSIX names it, no header need declare it

namespace pathrace::testing {
namespace {

// The test's end and the program's end.
std::array<int, 2> open_pair(Running::Stderr kind) {
  std::array<int, 2> ends{-1, -1};
  if (kind == Running::Stderr::pipe) {
    if (pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
    return ends;
  }
  ends[0] = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
  if (ends[0] < 0 || grantpt(ends[0]) != 0 || unlockpt(ends[0]) != 0) throw std::runtime_error("no terminal");
  ends[1] = open(ptsname(ends[0]), O_RDWR | O_NOCTTY | O_CLOEXEC);  // NOLINT(concurrency-mt-unsafe)
  return ends;
}

void take_a_breath() {
  poll(nullptr, 0, 2);
}

}  // namespace

Running::Running(const std::string& program, const std::vector<std::string>& arguments, Stderr kind) {
  const std::array<int, 2> ends = open_pair(kind);
  err_fd_ = ends[0];
  std::vector<std::string> words{program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDERR_FILENO);
  const int error = posix_spawn(&child_, program.c_str(), &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  close(ends[1]);
  if (error != 0) throw std::system_error(error, std::generic_category(), program);
}

Running::~Running() {
  if (child_ > 0) {
    kill(child_, SIGKILL);
    waitpid(child_, nullptr, 0);
  }
  close(err_fd_);
}

bool Running::read_more() {
  std::array<char, 4096> bytes{};
  const ssize_t count = read(err_fd_, bytes.data(), bytes.size());
  if (count <= 0) return false;  // a terminal whose other end is closed gives an error
  err_.append(bytes.data(), static_cast<std::size_t>(count));
  return true;
}

bool Running::says(const std::string& text) {
  while (err_.find(text) == std::string::npos) {
    if (!read_more()) return false;
  }
  return true;
}

bool Running::ended() const {
  siginfo_t info{};
  return waitid(P_PID, static_cast<id_t>(child_), &info, WEXITED | WNOHANG | WNOWAIT) != 0 ||
         info.si_pid != 0;
}

double Running::worked_s() const {
  std::ifstream in("/proc/" + std::to_string(child_) + "/stat");
  std::string text;
  std::getline(in, text);
  std::istringstream fields(text.substr(text.rfind(')') + 2));
  std::string skipped;
  for (int field = 3; field < 14; ++field) fields >> skipped;
  double user = 0;
  double system = 0;
  fields >> user >> system;
  return (user + system) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

bool Running::works(double seconds) {
  const double until = worked_s() + seconds;
  while (!ended()) {
    if (worked_s() >= until) return true;
    take_a_breath();
  }
  return false;
}

bool Running::handles(int signal) const {
  while (!ended()) {
    std::ifstream in("/proc/" + std::to_string(child_) + "/status");
    std::string line;
    while (std::getline(in, line) && !line.starts_with("SigCgt:")) {
    }
    const std::uint64_t caught = std::stoull(line.substr(7), nullptr, 16);
    if ((caught >> (signal - 1) & 1) != 0) return true;
    take_a_breath();
  }
  return false;
}

void Running::send(int signal) const {
  kill(child_, signal);
}

Running::End Running::wait() {
  while (read_more()) {
  }
  End end;
  rusage usage{};
  if (wait4(child_, &end.status, 0, &usage) != child_) throw std::runtime_error("the program was lost");
  child_ = -1;
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  end.user_and_sys = seconds(usage.ru_utime) + seconds(usage.ru_stime);
  return end;
}

}  // namespace pathrace::testing
