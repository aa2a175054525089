#include "apps/run/stats_file.h"

#include <nlohmann/json.hpp>

#include "history/json_text.h"

namespace voroproof::internal {
namespace {

using Json = nlohmann::ordered_json;

Json flips(const EngineStats& stats) {
  Json all = {{"all", stats.flip_count()}};
  for (std::size_t kind = 0; kind < stats.flips.size(); ++kind) {
    all[std::string(flip_kind_names[kind])] = stats.flips[kind];
  }
  return all;
}

Json tiers(const TierCounts& counts) {
  Json all = Json::object();
  for (std::size_t p = 0; p < counts.decided.size(); ++p) {
    Json& predicate = all[std::string(predicate_names[p])];
    for (std::size_t t = 0; t < counts.decided[p].size(); ++t) {
      predicate[std::string(tier_names[t])] = counts.decided[p][t];
    }
  }
  return all;
}

}  // namespace

std::string stats_text(const RunDescription& run, const Outcome& outcome,
                       const EngineStats& stats) {
  Json json = Json::object();
  json["format"] = "voroproof-stats";
  json["version"] = 1;
  json["producer"] = run.producer;
  json["scene_sha256"] = run.scene_sha256;
  json["disks"] = run.disks;
  json["horizon"] = Json::parse(number_text(run.horizon));
  json["options"] = {{"start_bits", run.start_bits},
                     {"max_bits", run.max_bits},
                     {"threads", run.threads},
                     {"filters", run.filters}};
  json["outcome"] = name_of(outcome.kind);
  if (!outcome.reason.empty()) json["reason"] = outcome.reason;
  json["t"] = stats.end;
  json["events"] = {{"flips", flips(stats)},
                    {"collisions",
                     {{"all", stats.disk_collisions + stats.wall_collisions},
                      {"disks", stats.disk_collisions},
                      {"container", stats.wall_collisions}}},
                    {"maneuvers", stats.maneuvers}};
  json["predicted"] = {{"flips", stats.predicted_flips},
                       {"collisions", stats.predicted_collisions}};
  json["searches"] = {{"flips", stats.flip_searches}, {"collisions", stats.contact_searches}};
  json["ties"] = stats.ties;
  json["settling_flips"] = stats.settling_flips;
  json["slices"] = stats.slices;
  json["decided_by"] = tiers(stats.tiers);
  json["precision"] = {{"highest_bits", stats.highest_bits},
                       {"goal_bits", stats.goal_bits},
                       {"replays", stats.replays}};
  json["seconds"] = {{"total", run.total_seconds},
                     {"initial_diagram", stats.initial_seconds},
                     {"step1_flip_times", stats.flip_seconds},
                     {"step2_collision_times", stats.collision_seconds},
                     {"step3_queue", stats.queue_seconds},
                     {"step4_move", stats.move_seconds}};
  // Other text than ASCII can come from the reason only, and is UTF-8 there.
  return json.dump(2) + "\n";
}

}  // namespace voroproof::internal
