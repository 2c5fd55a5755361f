#include "bench/cli/cli.hpp"

int main(int argc, char** argv) {
  return pathrace::bench::cli::run(argc, argv);
}
