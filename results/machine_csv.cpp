#include "results/machine_csv.hpp"

#include "results/csv.hpp"

namespace pathrace::results {

void write_machine_csv(std::ostream& out, const Store& store) {
  write_csv_line(out, {"session", "name", "value"});
  store.for_each_fact([&out](int session, const MachineFact& fact) {
    write_csv_line(out, {std::to_string(session), fact.name, fact.value});
  });
}

}  // namespace pathrace::results
