#include "results/scenario_writer.hpp"

#include "core/hash.hpp"
#include "results/binder.hpp"

namespace pathrace::results {

ScenarioWriter::ScenarioWriter(SQLite::Database& database)
    : numbers_(database),
      references_(database),
      put_question_(
          database,
          "INSERT OR REPLACE INTO question (scenario, width, height, start_x, start_y, goal_x, goal_y, hash) "
          "VALUES (?, ?, ?, ?, ?, ?, ?, ?)"),
      put_feature_(database,
                   "INSERT INTO feature (scenario, name, value) VALUES (?, ?, ?) "
                   "ON CONFLICT (scenario, name) DO UPDATE SET value = excluded.value") {}

void ScenarioWriter::write(const ScenarioRow& row) {
  const std::int64_t number = numbers_.number(row.id, row.rule);
  references_.put(number, row.id, Track::lattice, row.optimum);
  references_.put(number, row.id, Track::any_angle, row.any_angle_optimum);
  Binder(put_question_)
      .integer(number)
      .integer(std::int64_t{row.width})
      .integer(std::int64_t{row.height})
      .integer(std::int64_t{row.start.x})
      .integer(std::int64_t{row.start.y})
      .integer(std::int64_t{row.goal.x})
      .integer(std::int64_t{row.goal.y})
      .name(hex(row.hash));
  put_question_.exec();
  for (const FeatureValue& feature : row.features) {
    Binder(put_feature_).integer(number).text(feature.name).real(feature.value);
    put_feature_.exec();
  }
}

}  // namespace pathrace::results
