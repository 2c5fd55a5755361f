// The launcher script in a checkout of its own, with a toolbox of small scripts in place of CMake, CTest,
// dpkg-query, apt-get and sudo. Each of them writes its name and arguments into `calls`; a file named after
// a tool's failing makes it fail.
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "tests/support/process.hpp"

namespace pathrace::bench {
namespace {

namespace fs = std::filesystem;

constexpr auto fake_cmake = R"sh(#!/bin/bash
echo "cmake $*" >>"$CALLS"
root=$(dirname "$CALLS")/check\ out
build=$root/build/release
if [[ $1 == --preset ]]; then
  [[ $* != *--fresh* && -e $root/../damaged ]] && exit 1
  rm -f "$root/../damaged"
  mkdir -p "$build"
  [[ $* == *TESTS=ON* ]] && tests=ON || tests=OFF
  printf 'CMAKE_HOME_DIRECTORY:INTERNAL=%s\nPATHRACE_TESTS:BOOL=%s\n' "$root" "$tests" >"$build/CMakeCache.txt"
  : >"$build/build.ninja"
else
  [[ -e $root/../damaged ]] && { echo "ninja: error: loading 'build.ninja'"; exit 1; }
  [[ -e $root/../compiler_error ]] && { printf 'FAILED: a.o\na.cpp:1: error: no\n'; exit 1; }
  [[ $* == *micro* ]] && cp "$(dirname "$0")/binary" "$build/pathrace_micro"
  cp "$(dirname "$0")/binary" "$build/pathrace"
fi
)sh";

constexpr auto fake_binary = R"sh(#!/bin/bash
echo "in $PWD with <$PATHRACE_DATA>:$(printf ' [%s]' "$@")"
exit "${EXIT:-0}"
)sh";

// Knows every package but those that the file `missing` names.
constexpr auto fake_dpkg_query = R"sh(#!/bin/bash
[[ -e ${CALLS%/*}/missing ]] && not_there=$(<"${CALLS%/*}/missing")
for package in "${@:4}"; do
  [[ " ${not_there//$'\n'/ } " == *" $package "* ]] && missing=1 || echo "$package installed"
done
exit "${missing:-0}"
)sh";

// Installs whatever the file `unobtainable` does not name.
constexpr auto fake_apt_get = R"sh(#!/bin/bash
echo "apt-get $*" >>"$CALLS"
folder=$(dirname "$CALLS")
if [[ $* == *update* ]]; then rm -f "$folder/stale"; exit 0; fi
[[ -e $folder/stale ]] && { echo "E: 404 Not Found"; exit 100; }
for package in "$@"; do
  grep -qxs "$package" "$folder/unobtainable" && { echo "E: Unable to locate package $package"; exit 100; }
done
for package in "$@"; do sed -i "/^$package$/d" "$folder/missing"; done
)sh";

constexpr auto fake_ctest = R"sh(#!/bin/bash
echo "ctest $*" >>"$CALLS"
echo "100% tests passed"
exit "${EXIT:-0}"
)sh";

constexpr auto fake_sudo = R"sh(#!/bin/bash
[[ -e $(dirname "$CALLS")/no_sudo ]] && { echo "sudo: a password is required" >&2; exit 1; }
shift
exec "$@"
)sh";

using pathrace::testing::Finished;

class Launcher : public ::testing::Test {
 protected:
  Launcher() {
    for (const char* folder :
         {"cmake", "campaigns", "core", "scenarios", "algorithms", "baselines", "results", "bench"}) {
      write(root() / folder / "a.cpp", "1");
    }
    write(root() / "CMakeLists.txt", "1");
    write(root() / "CMakePresets.json", "1");
    write(root() / "README.md", "1");
    fs::copy_file(fs::path(PATHRACE_SOURCE_DIR) / "pathrace", root() / "pathrace");
    add_tool("cmake", fake_cmake);
    add_tool("binary", fake_binary);
    add_tool("ctest", fake_ctest);
    add_tool("dpkg-query", fake_dpkg_query);
    add_tool("apt-get", fake_apt_get);
    add_tool("sudo", fake_sudo);
  }

  fs::path root() const { return home_ / "check out"; }
  fs::path home() const { return home_; }

  static void write(const fs::path& file, const std::string& text) {
    fs::create_directories(file.parent_path());
    std::ofstream(file) << text;
  }

  static std::string read(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
  }

  std::string calls() const { return read(home_ / "calls"); }

  std::size_t count_calls(const std::string& word) const {
    const std::string text = calls();
    std::size_t count = 0;
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++count;
    return count;
  }

  /// Runs a shell command in a folder that is not the checkout.
  Finished shell(const std::string& command, const std::string& variables = "") const {
    const std::string line = "cd '" + home_.string() + "' && env -i PATH='" + (home_ / "tools").string() +
                             ":/usr/bin:/bin' CALLS='" + (home_ / "calls").string() + "' " + variables + " " +
                             command;
    return pathrace::testing::run_program("/bin/bash", {"-c", line});
  }

  Finished launch(const std::string& arguments = "", const std::string& variables = "") const {
    return shell("'check out/pathrace' " + arguments, variables);
  }

  /// The same as somebody who is not root and may not use sudo.
  Finished launch_without_rights() const {
    write(home_ / "no_sudo", "");
    const bool is_root = geteuid() == 0;
    return shell(std::string(is_root ? "setpriv --reuid=65534 --regid=65534 --clear-groups " : "") +
                 "'check out/pathrace'");
  }

 private:
  void add_tool(const std::string& name, const char* script) const {
    write(home_ / "tools" / name, script);
    fs::permissions(home_ / "tools" / name,
                    fs::perms::owner_all | fs::perms::others_read | fs::perms::others_exec);
  }

  pathrace::testing::ScratchFolder scratch_;
  fs::path home_ = fs::canonical(scratch_.path());
};

TEST_F(Launcher, BuildsOnTheFirstCallAndBecomesTheBinary) {
  const Finished outcome = launch("plan 'two words'", "EXIT=7");
  EXPECT_EQ(outcome.exit_code, 7);
  EXPECT_EQ(outcome.out, "in " + home().string() + " with <>: [plan] [two words]\n");
  EXPECT_EQ(count_calls("cmake --preset release"), 1U);
  EXPECT_EQ(count_calls("--target pathrace\n"), 1U);
  EXPECT_EQ(count_calls("apt-get"), 0U);
}

TEST_F(Launcher, SaysNothingAndCallsNoToolWhenTheBinaryIsCurrent) {
  launch();
  fs::remove(home() / "calls");
  const Finished outcome = launch("planners");
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(outcome.out, "in " + home().string() + " with <>: [planners]\n");
  EXPECT_EQ(calls(), "");
}

TEST_F(Launcher, BuildsAgainWhenASourceWasChangedAddedOrRemoved) {
  launch();
  write(root() / "core/a.cpp", "22");
  launch();
  EXPECT_EQ(count_calls("cmake --build"), 2U);
  write(root() / "algorithms/aco/new.def", "1");
  launch();
  EXPECT_EQ(count_calls("cmake --build"), 3U);
  fs::remove(root() / "bench/a.cpp");
  launch();
  EXPECT_EQ(count_calls("cmake --build"), 4U);
  EXPECT_EQ(count_calls("cmake --preset"), 1U);
}

TEST_F(Launcher, DoesNotBuildAgainForTextsTestsOrRuns) {
  launch();
  write(root() / "README.md", "22");
  write(root() / "bench/notes.md", "22");
  write(root() / "tests/core/a_test.cpp", "22");
  write(root() / "runs/starter-1/trials.csv", "22");
  launch();
  EXPECT_EQ(count_calls("cmake --build"), 1U);
}

TEST_F(Launcher, WorksThroughASymbolicLink) {
  fs::create_symlink(root() / "pathrace", home() / "link");
  EXPECT_EQ(shell("./link a").out, "in " + home().string() + " with <>: [a]\n");
}

TEST_F(Launcher, ARelativeDataFolderCountsFromTheRootOfTheRepository) {
  EXPECT_EQ(launch("", "PATHRACE_DATA=../data").out,
            "in " + home().string() + " with <" + root().string() + "/../data>: []\n");
  EXPECT_EQ(launch("", "PATHRACE_DATA=/data").out, "in " + home().string() + " with </data>: []\n");
}

TEST_F(Launcher, InstallsMissingPackagesAndShowsTheLineBeforeItRunsIt) {
  write(home() / "missing", "libtbb-dev\nlibfmt-dev\n");
  const Finished outcome = launch();
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(count_calls("apt-get"), 1U);
  const std::string line = "install --yes --no-install-recommends libfmt-dev libtbb-dev\n";
  EXPECT_NE(calls().find(line), std::string::npos) << calls();
  EXPECT_NE(outcome.err.find(line), std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.out, "in " + home().string() + " with <>: []\n");
}

TEST_F(Launcher, InstallsOptionalPackagesAsWell) {
  write(home() / "missing", "libompl-dev\nlibeigen3-dev\nlibbenchmark-dev\n");
  const Finished outcome = launch();
  EXPECT_EQ(outcome.exit_code, 0);
  const std::string line =
      "install --yes --no-install-recommends libompl-dev libeigen3-dev libbenchmark-dev\n";
  EXPECT_NE(calls().find(line), std::string::npos) << calls();
  EXPECT_NE(outcome.err.find(line), std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.err.find("without"), std::string::npos) << outcome.err;
}

TEST_F(Launcher, BuildsWithoutOptionalPackagesThatCannotBeHadAndNamesThemOnOneLine) {
  write(home() / "missing", "libompl-dev\nlibtbb-dev\n");
  write(home() / "unobtainable", "libompl-dev\n");
  const Finished outcome = launch();
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(count_calls("install --yes --no-install-recommends libtbb-dev\n"), 1U);
  EXPECT_EQ(count_calls("cmake --build"), 1U);
  EXPECT_NE(outcome.err.find("\npathrace: building without libompl-dev: apt-get cannot install them ("),
            std::string::npos)
      << outcome.err;
  EXPECT_EQ(launch().err, "");
}

TEST_F(Launcher, BuildsWithoutOptionalPackagesWhereInstallingIsForbiddenAndNamesThemOnOneLine) {
  write(home() / "missing", "libompl-dev\nlibbenchmark-dev\n");
  const Finished outcome = launch("", "PATHRACE_NO_INSTALL=1");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(count_calls("apt-get"), 0U);
  EXPECT_TRUE(outcome.err.starts_with(
      "pathrace: building without libompl-dev libbenchmark-dev: PATHRACE_NO_INSTALL=1 "
      "forbids to install them. README.md says what for; later: sudo apt-get install "
      "--yes --no-install-recommends libompl-dev libbenchmark-dev\n"))
      << outcome.err;
}

TEST_F(Launcher, BuildsWithoutOptionalPackagesWhereThereIsNoRightToInstallThem) {
  write(home() / "missing", "libompl-dev\n");
  fs::permissions(home(), fs::perms::all);
  fs::permissions(root(), fs::perms::all);
  write(home() / "calls", "");
  fs::permissions(home() / "calls", fs::perms::all);
  const Finished outcome = launch_without_rights();
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(count_calls("apt-get"), 0U);
  EXPECT_NE(outcome.err.find("without libompl-dev: there is no right to install them."), std::string::npos)
      << outcome.err;
}

TEST_F(Launcher, ConfiguresAgainWhenAnOptionalPackageCameOrWent) {
  write(home() / "missing", "libompl-dev\n");
  launch("", "PATHRACE_NO_INSTALL=1");
  fs::remove(home() / "missing");
  EXPECT_EQ(launch().exit_code, 0);
  EXPECT_EQ(count_calls("cmake --preset"), 2U);
  EXPECT_EQ(count_calls("cmake --build"), 2U);
  EXPECT_EQ(launch().err, "");
  write(home() / "missing", "libompl-dev\n");
  EXPECT_EQ(launch("", "PATHRACE_NO_INSTALL=1").exit_code, 0);
  EXPECT_EQ(count_calls("cmake --preset"), 3U);
}

TEST_F(Launcher, UpdatesThePackageListsWhenInstallingFails) {
  write(home() / "missing", "libtbb-dev\n");
  write(home() / "stale", "");
  EXPECT_EQ(launch().exit_code, 0);
  EXPECT_EQ(count_calls("apt-get"), 3U);
  EXPECT_EQ(count_calls(" update\n"), 1U);
}

TEST_F(Launcher, NamesThePackagesAndStopsWhereInstallingIsForbidden) {
  write(home() / "missing", "libtbb-dev\n");
  const Finished outcome = launch("", "PATHRACE_NO_INSTALL=1");
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_EQ(outcome.out, "");
  EXPECT_NE(outcome.err.find("libtbb-dev"), std::string::npos) << outcome.err;
  EXPECT_EQ(calls(), "");
}

TEST_F(Launcher, NamesThePackagesAndStopsWithoutTheRightToInstallThem) {
  write(home() / "missing", "libtbb-dev\n");
  fs::permissions(home(), fs::perms::all);
  fs::permissions(root(), fs::perms::all);
  const Finished outcome = launch_without_rights();
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_NE(outcome.err.find("apt-get install --yes --no-install-recommends libtbb-dev\n"), std::string::npos)
      << outcome.err;
  EXPECT_EQ(calls(), "");
}

TEST_F(Launcher, SaysSoWhenTheCheckoutCannotBeWritten) {
  fs::permissions(home(), fs::perms::all);
  const auto read_only =
      fs::perms::owner_read | fs::perms::owner_exec | fs::perms::others_read | fs::perms::others_exec;
  fs::permissions(root(), read_only);
  const Finished outcome = launch_without_rights();
  fs::permissions(root(), fs::perms::owner_all);
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_EQ(outcome.err, "pathrace: cannot write to " + root().string() +
                             "/build, and there is no current binary; check permissions and space\n");
}

TEST_F(Launcher, RunsACurrentBinaryFromACheckoutThatCannotBeWritten) {
  launch();
  fs::permissions(home(), fs::perms::all);
  fs::permissions(root() / "build/release/pathrace", fs::perms::others_exec | fs::perms::others_read,
                  fs::perm_options::add);
  for (const fs::path& folder : {root(), root() / "build", root() / "build/release"}) {
    fs::permissions(folder, fs::perms::owner_write, fs::perm_options::remove);
  }
  const Finished outcome = launch_without_rights();
  for (const fs::path& folder : {root(), root() / "build", root() / "build/release"}) {
    fs::permissions(folder, fs::perms::owner_write, fs::perm_options::add);
  }
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
}

TEST_F(Launcher, ACompilersErrorIsShownOnceAndTheNextCallTriesAgain) {
  launch();
  write(root() / "core/a.cpp", "22");
  write(home() / "compiler_error", "");
  const Finished failed = launch();
  EXPECT_EQ(failed.exit_code, 3);
  EXPECT_EQ(failed.out, "");
  EXPECT_NE(failed.err.find("a.cpp:1: error: no\n"), std::string::npos) << failed.err;
  EXPECT_EQ(count_calls("--fresh"), 0U);
  EXPECT_EQ(launch().exit_code, 3);
  fs::remove(home() / "compiler_error");
  EXPECT_EQ(launch().exit_code, 0);
}

TEST_F(Launcher, ConfiguresADamagedBuildFolderAfresh) {
  launch();
  fs::remove(root() / "build/release/pathrace");
  write(home() / "damaged", "");
  EXPECT_EQ(launch().exit_code, 0);
  EXPECT_EQ(count_calls("--fresh"), 1U);
}

TEST_F(Launcher, ConfiguresAgainWhenTheCacheIsGoneOrBelongsToAnotherCheckout) {
  launch();
  fs::remove(root() / "build/release/pathrace");
  fs::remove(root() / "build/release/CMakeCache.txt");
  EXPECT_EQ(launch().exit_code, 0);
  EXPECT_EQ(count_calls("cmake --preset"), 2U);
  fs::remove(root() / "build/release/pathrace");
  write(root() / "build/release/CMakeCache.txt", "CMAKE_HOME_DIRECTORY:INTERNAL=/elsewhere\n");
  EXPECT_EQ(launch().exit_code, 0);
  EXPECT_EQ(count_calls("cmake --preset"), 3U);
}

TEST_F(Launcher, OfSeveralAtOnceOneBuildsAndTheOthersWait) {
  std::array<Finished, 4> outcomes;
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    threads.emplace_back([&, i] { outcomes[i] = launch("x"); });
  }
  for (std::thread& thread : threads) thread.join();
  for (const Finished& outcome : outcomes) {
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "in " + home().string() + " with <>: [x]\n");
  }
  EXPECT_EQ(count_calls("cmake --build"), 1U);
}

TEST_F(Launcher, TestBuildsEverythingAndPassesArgumentsAndExitCodeOfCTestOn) {
  launch();
  const Finished outcome = launch("test -R 'Stream|Grid'", "EXIT=8");
  EXPECT_EQ(outcome.exit_code, 8);
  EXPECT_EQ(outcome.out, "100% tests passed\n");
  EXPECT_EQ(count_calls("-DPATHRACE_TESTS=ON\n"), 1U);
  EXPECT_EQ(count_calls("--target all\n"), 1U);
  EXPECT_EQ(count_calls(" -R Stream|Grid\n"), 1U);
}

TEST_F(Launcher, MicroBuildsTheMicroBenchmarksOnceAndAgainAfterAChange) {
  launch();
  const Finished outcome = launch("micro --filter x");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.out, "in " + home().string() + " with <>: [micro] [--filter] [x]\n");
  EXPECT_EQ(count_calls("--target pathrace pathrace_micro\n"), 1U);
  EXPECT_EQ(launch("micro").err, "");
  write(root() / "bench/a.cpp", "22");
  launch();
  launch("micro");
  EXPECT_EQ(count_calls("--target pathrace pathrace_micro\n"), 2U);
}

TEST_F(Launcher, MicroSaysOnOneLineThatItsPackageCannotBeHad) {
  write(home() / "missing", "libbenchmark-dev\n");
  const Finished outcome = launch("micro", "PATHRACE_NO_INSTALL=1");
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_EQ(
      outcome.err,
      "pathrace: missing Debian packages, and PATHRACE_NO_INSTALL=1 forbids to install them. Please type: "
      "sudo apt-get install --yes --no-install-recommends libbenchmark-dev\n");
}

TEST_F(Launcher, TestNeedsThePackageOfTheTestsAndARunDoesNot) {
  write(home() / "missing", "libgtest-dev\n");
  EXPECT_EQ(launch("", "PATHRACE_NO_INSTALL=1").exit_code, 0);
  const Finished outcome = launch("test", "PATHRACE_NO_INSTALL=1");
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_NE(outcome.err.find("libgtest-dev"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace pathrace::bench
