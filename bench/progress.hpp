// Progress: one line that renews itself on a terminal, a plain line now and then elsewhere. On stderr.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace pathrace::bench {

/// "2.4 s", "3 min 20 s", "1 h 5 min".
std::string print_duration(double seconds);

class Progress {
 public:
  /// `before`: trials recorded by earlier runs, `total`: of the whole campaign; `work_s`: what this run's
  /// trials are expected to take one after another, by which the time left is told.
  Progress(std::size_t before, std::size_t total, double work_s);
  /// `done`: trials recorded by this run; `worked_s`: what they were expected to take.
  void update(std::size_t done, double worked_s);
  /// Ends the renewing line.
  void close();

 private:
  std::string line(std::size_t done, double worked_s) const;

  std::size_t before_;
  std::size_t total_;
  double work_s_;
  bool terminal_;
  std::chrono::steady_clock::time_point begin_;
  std::chrono::steady_clock::time_point next_plain_line_;
  bool open_ = false;
};

}  // namespace pathrace::bench
