#include "bench/machine.hpp"

#include <fmt/format.h>
#include <gnu/libc-version.h>
#include <sys/utsname.h>
#include <tbb/version.h>
#include <unistd.h>

#include <ctime>
#include <fstream>
#include <string>
#include <string_view>
#include <thread>

namespace pathrace::bench {
namespace {

// The value of the first line "key<separator>value" of a file of the system; empty if there is none.
std::string line_of(const char* file, std::string_view key, char separator) {
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with(key)) continue;
    const std::size_t begin = line.find_first_not_of(" \t\"", line.find(separator) + 1);
    if (begin == std::string::npos) return "";
    return line.substr(begin, line.find_last_not_of(" \t\"") + 1 - begin);
  }
  return "";
}

std::string kernel() {
  utsname name{};
  if (::uname(&name) != 0) return "";
  return fmt::format("{} {} {}", name.sysname, name.release, name.machine);
}

std::string memory() {
  const long pages = ::sysconf(_SC_PHYS_PAGES);
  const long page = ::sysconf(_SC_PAGESIZE);
  return pages > 0 && page > 0 ? std::to_string(std::int64_t{pages} * page) : "";
}

std::string now() {
  const std::time_t time = std::time(nullptr);
  std::tm utc{};
  ::gmtime_r(&time, &utc);
  return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}Z", utc.tm_year + 1900, utc.tm_mon + 1, utc.tm_mday,
                     utc.tm_hour, utc.tm_min, utc.tm_sec);
}

std::string compiler() {
#if defined(__clang__)
  return "clang++ " __clang_version__;
#else
  return "g++ " __VERSION__;
#endif
}

std::string openmp() {
#ifdef _OPENMP
  return std::to_string(_OPENMP);  // year and month of the specification
#else
  return "";
#endif
}

}  // namespace

std::vector<results::MachineFact> machine_facts() {
  std::vector<results::MachineFact> facts = {
      {"date", now()},
      {"pathrace", PATHRACE_VERSION},
      {"source", PATHRACE_SOURCE_STATE},
      {"processor", line_of("/proc/cpuinfo", "model name", ':')},
      {"cores", std::to_string(std::thread::hardware_concurrency())},
      {"memory", memory()},
      {"system", line_of("/etc/os-release", "PRETTY_NAME", '=')},
      {"kernel", kernel()},
      {"compiler", compiler()},
      {"flags", PATHRACE_FLAGS},
      {"libc", ::gnu_get_libc_version()},
      {"tbb", fmt::format("{}.{}", TBB_VERSION_MAJOR, TBB_VERSION_MINOR)},
      {"openmp", openmp()},
      {"ompl", PATHRACE_OMPL_VERSION},
      {"sqlite", results::sqlite_version()},
  };
  std::erase_if(facts, [](const results::MachineFact& fact) { return fact.value.empty(); });
  return facts;
}

}  // namespace pathrace::bench
