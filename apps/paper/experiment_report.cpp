#include "apps/paper/experiment_report.h"

#include <nlohmann/json.hpp>

#include "history/error.h"
#include "history/file_bytes.h"
#include "history/json_text.h"

namespace voroproof::internal {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view format_name = "voroproof-experiment";
constexpr std::uint64_t longest_file = std::uint64_t{1} << 28;

Json distribution_json(const Distribution& d) {
  return {{"count", d.count},
          {"mean", d.mean},
          {"standard_deviation", d.deviation},
          {"five_numbers", {d.least, d.lower_quartile, d.median, d.upper_quartile, d.greatest}}};
}

// The line of a member in the table.
std::string csv_line(const std::string& set, const Json& member) {
  const auto real = [](const Json& value) { return number_text(value.get<double>()); };
  const auto count = [](const Json& value) { return std::to_string(value.get<std::uint64_t>()); };
  const auto predicted = [&](const char* what) {
    return member.contains("predicted") ? count(member.at("predicted").at(what)) : std::string();
  };
  const Json &collisions = member.at("collisions"), &distance = member.at("neighbor_distance"),
             &speed = member.at("speed_at_end");
  const std::vector<std::string> fields{set,
                                        count(member.at("k")),
                                        count(member.at("n")),
                                        real(member.at("speed")),
                                        real(member.at("rmax")),
                                        real(member.at("density")),
                                        real(member.at("restitution")),
                                        count(member.at("seed")),
                                        real(member.at("horizon")),
                                        member.at("outcome").get<std::string>(),
                                        real(member.at("t")),
                                        count(member.at("flips")),
                                        count(collisions.at("disks")),
                                        count(collisions.at("container")),
                                        predicted("flips"),
                                        predicted("flips_before_contact"),
                                        predicted("roots"),
                                        predicted("collisions"),
                                        real(distance.at("mean")),
                                        real(distance.at("standard_deviation")),
                                        real(speed.at("mean")),
                                        real(speed.at("standard_deviation"))};
  std::string line;
  for (std::size_t f = 0; f < fields.size(); ++f) line += (f == 0 ? "" : ",") + fields[f];
  return line + '\n';
}

}  // namespace

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

std::string experiment_json(const Experiment& experiment) {
  const Json json = {{"format", format_name},           {"version", 1},
                     {"producer", experiment.producer}, {"set", experiment.set},
                     {"scale", experiment.scale},       {"members", experiment.members}};
  return json.dump(1) + "\n";
}

std::string experiment_csv(const Experiment& experiment) {
  std::string text =
      "set,k,n,speed,rmax,density,restitution,seed,horizon,outcome,t,flips,disk_collisions,"
      "wall_collisions,predicted_flips,predicted_flips_before_contact,predicted_roots,predicted_"
      "collisions,"
      "neighbor_distance_mean,"
      "neighbor_distance_deviation,speed_mean,speed_deviation\n";
  for (const Json& member : experiment.members) text += csv_line(experiment.set, member);
  return text;
}

Experiment read_experiment(const std::string& path) {
  Experiment experiment;
  try {
    const Json json = Json::parse(file_bytes(path, longest_file));
    if (json.at("format") != format_name || json.at("version") != 1) {
      throw InputError(path, 0, "format", "not of an experiment");
    }
    experiment.producer = json.at("producer");
    experiment.set = json.at("set");
    experiment.scale = json.at("scale");
    for (const Json& member : json.at("members")) {
      csv_line(experiment.set, member);  // checks that the fields others ask for are there
      experiment.members.push_back(member);
    }
  } catch (const nlohmann::json::exception&) {
    throw InputError(path, 0, "", "not of an experiment");
  }
  return experiment;
}

}  // namespace voroproof::internal
