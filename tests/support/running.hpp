// A program that runs while a test watches it: what it writes to stderr, how much work it has done, signals.
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace pathrace::testing {

class Running {
 public:
  enum class Stderr { pipe, terminal };

  /// Starts a program without a shell, with no standard input and its standard output thrown away.
  Running(const std::string& program, const std::vector<std::string>& arguments, Stderr kind = Stderr::pipe);
  /// Kills it if it still runs.
  ~Running();
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

  /// Reads stderr until it holds this text; false when it ends before.
  bool says(const std::string& text);
  /// All of stderr that has been read.
  const std::string& err() const { return err_; }
  /// Waits until the process has worked so many more seconds of processor time; false when it ends before.
  bool works(double seconds);
  /// Waits until it handles this signal; false when it ends before.
  bool handles(int signal) const;
  void send(int signal) const;

  struct End {
    int status = 0;           ///< as waitpid gives it
    double user_and_sys = 0;  ///< processor seconds, all threads, from start to end
  };
  /// Reads stderr to its end and waits.
  End wait();

  /// Processor seconds of all threads so far.
  double worked_s() const;

 private:
  bool read_more();
  bool ended() const;

  pid_t child_ = -1;
  int err_fd_ = -1;
  std::string err_;
};

}  // namespace pathrace::testing
