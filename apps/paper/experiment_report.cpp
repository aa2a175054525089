#include "apps/paper/experiment_report.h"

#include <nlohmann/json.hpp>

#include "history/json_text.h"

namespace voroproof::internal {
namespace {

using Json = nlohmann::ordered_json;

Json distribution_json(const Distribution& d) {
  return {{"count", d.count},
          {"mean", d.mean},
          {"standard_deviation", d.deviation},
          {"five_numbers", {d.least, d.lower_quartile, d.median, d.upper_quartile, d.greatest}}};
}

Json member_json(const ExperimentMember& member, bool predictions) {
  const ReferenceOptions& options = member.options;
  const ExperimentRun& run = member.run;
  const EngineStats& stats = run.stats;
  Json json = {{"k", member.k},
               {"n", run.disks},
               {"speed", options.speed},
               {"rmin", options.rmin},
               {"rmax", options.rmax},
               {"density", options.density},
               {"restitution", options.restitution},
               {"seed", options.seed},
               {"horizon", options.horizon},
               {"outcome", std::string(name_of(run.outcome.kind))},
               {"t", run.outcome.t}};
  if (!run.outcome.reason.empty()) json["reason"] = run.outcome.reason;
  json["flips"] = stats.flip_count();
  json["collisions"] = {{"disks", stats.disk_collisions}, {"container", stats.wall_collisions}};
  if (predictions && run.outcome.kind == Outcome::Kind::complete)
    json["predicted"] = {{"flips", run.predicted_flips},
                         {"flips_before_contact", run.predicted_flips_before_contact},
                         {"roots", run.predicted_roots},
                         {"collisions", run.predicted_collisions}};
  json["searched"] = {{"flips", stats.flip_searches},
                      {"found_flips", stats.predicted_flips},
                      {"collisions", stats.contact_searches},
                      {"found_collisions", stats.predicted_collisions}};
  json["highest_bits"] = stats.highest_bits;
  json["seconds"] = {{"total", run.seconds},
                     {"initial_diagram", stats.initial_seconds},
                     {"step1_flip_times", stats.flip_seconds},
                     {"step2_collision_times", stats.collision_seconds},
                     {"step3_queue", stats.queue_seconds},
                     {"step4_move", stats.move_seconds}};
  json["neighbor_distance"] = distribution_json(run.neighbor_distance);
  json["speed_at_end"] = distribution_json(run.speed);
  json["frequency_interval"] = frequency_interval;
  json["flip_frequency"] = run.flip_frequency;
  json["collision_frequency"] = run.collision_frequency;
  return json;
}

}  // namespace

std::string experiment_json(const Experiment& experiment) {
  Json json;
  json["format"] = "voroproof-experiment";
  json["version"] = 1;
  json["producer"] = experiment.producer;
  json["set"] = experiment.set;
  json["scale"] = experiment.scale;
  json["members"] = Json::array();
  for (const ExperimentMember& member : experiment.members)
    json["members"].push_back(member_json(member, experiment.predictions));
  return json.dump(1) + "\n";
}

std::string experiment_csv(const Experiment& experiment) {
  std::string text =
      "set,k,n,speed,rmax,density,restitution,seed,horizon,outcome,t,flips,disk_collisions,"
      "wall_collisions,predicted_flips,predicted_flips_before_contact,predicted_roots,predicted_"
      "collisions,"
      "neighbor_distance_mean,"
      "neighbor_distance_deviation,speed_mean,speed_deviation\n";
  for (const ExperimentMember& member : experiment.members) {
    const ReferenceOptions& o = member.options;
    const ExperimentRun& run = member.run;
    const bool predicted = experiment.predictions && run.outcome.kind == Outcome::Kind::complete;
    const auto count = [](std::uint64_t c) { return std::to_string(c); };
    const std::vector<std::string> fields{
        experiment.set,
        std::to_string(member.k),
        std::to_string(run.disks),
        number_text(o.speed),
        number_text(o.rmax),
        number_text(o.density),
        number_text(o.restitution),
        count(o.seed),
        number_text(o.horizon),
        name_of(run.outcome.kind),
        number_text(run.outcome.t),
        count(run.stats.flip_count()),
        count(run.stats.disk_collisions),
        count(run.stats.wall_collisions),
        predicted ? count(run.predicted_flips) : "",
        predicted ? count(run.predicted_flips_before_contact) : "",
        predicted ? count(run.predicted_roots) : "",
        predicted ? count(run.predicted_collisions) : "",
        number_text(run.neighbor_distance.mean),
        number_text(run.neighbor_distance.deviation),
        number_text(run.speed.mean),
        number_text(run.speed.deviation)};
    for (std::size_t f = 0; f < fields.size(); ++f) text += (f == 0 ? "" : ",") + fields[f];
    text += '\n';
  }
  return text;
}

}  // namespace voroproof::internal
