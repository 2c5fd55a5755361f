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
  /// `before`: trials recorded by earlier runs, `total`: of the whole campaign.
  Progress(std::size_t before, std::size_t total);
  /// `done`: trials recorded by this run; the time left is told by what they took on average.
  void update(std::size_t done);
  /// Ends the renewing line.
  void close();

 private:
  std::string line(std::size_t done) const;

  std::size_t before_;
  std::size_t total_;
  bool terminal_;
  std::chrono::steady_clock::time_point begin_;
  std::chrono::steady_clock::time_point next_plain_line_;
  bool open_ = false;
};

}  // namespace pathrace::bench
