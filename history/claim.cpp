#include "history/claim.h"

#include <numeric>
#include <optional>
#include <utility>

#include "history/disk_file.h"
#include "history/error.h"
#include "history/evtsq_reader.h"
#include "history/json_text.h"

namespace voroproof::internal {

namespace {

// A run may be shorter or longer than its scene asks for: it is judged up to its own horizon.
void note_horizon(Claim& claim) {
  const Rational& horizon = claim.history->header().horizon;
  if (round_nearest(horizon) == round_nearest(claim.scene.horizon)) return;
  claim.remarks.push_back("the horizon of the history is " + number_text(horizon) +
                          ", that of the scene " + number_text(claim.scene.horizon));
}

Claim open_event_sequence(const std::string& scene_path, const std::string& path) {
  Claim claim;
  if (is_disk_file(scene_path)) {
    DiskFile disks = read_disk_file(scene_path);
    std::vector<std::int64_t>& ids = disks.ids;
    EvtsqSetting setting = read_evtsq_setting(path, ids);
    const EvtsqHeader& header = setting.header;
    claim.scene = std::move(disks.scene);
    // The nearest binary64, as the writing program had it.
    claim.scene.restitution = to_rational(round_nearest(header.restitution));
    claim.scene.container_restitution = claim.scene.restitution;
    claim.scene.horizon = header.horizon;
    claim.scene.maneuvers = std::move(setting.maneuvers);
    claim.remarks.push_back("horizon " + number_text(claim.scene.horizon) + " and restitution " +
                            number_text(claim.scene.restitution) +
                            " are from the event sequence, to two decimals; the container scales "
                            "the whole reflected velocity");
    if (!claim.scene.maneuvers.empty()) {
      claim.remarks.push_back(
          "the velocity changes are from the event sequence: no scene names them");
    }
    if (!ids.empty() && ids.back() != static_cast<std::int64_t>(ids.size()) - 1) {
      claim.remarks.push_back("the disks are renumbered from 0 in the order of their ids");
    }
    if (claim.scene.restitution == 0) {
      throw InputError(path, 0, "RESTITUTION_COEFFICIENT", "0 is not possible at the container");
    }
    claim.history = open_evtsq(path, ids, std::nullopt, setting.sha256).history;
  } else {
    claim.scene = read_scene(scene_path);
    std::vector<std::int64_t> ids(claim.scene.disks.size());
    std::iota(ids.begin(), ids.end(), std::int64_t{0});
    EventSequence sequence = open_evtsq(path, ids, claim.scene.horizon);
    if (abs(Rational(claim.scene.restitution - sequence.header.restitution)) > evtsq_rounding()) {
      throw InputError(path, 0, "RESTITUTION_COEFFICIENT", "is not that of " + scene_path);
    }
    claim.history = std::move(sequence.history);
    note_horizon(claim);
  }
  return claim;
}

}  // namespace

Claim open_claim(const std::string& scene_path, const std::string& history_path) {
  if (is_evtsq_file(history_path)) return open_event_sequence(scene_path, history_path);
  Claim claim;
  claim.scene =
      is_disk_file(scene_path) ? read_disk_file(scene_path).scene : read_scene(scene_path);
  claim.history =
      open_history(history_path, static_cast<int>(claim.scene.disks.size()), claim.scene.sha256);
  note_horizon(claim);
  return claim;
}

}  // namespace voroproof::internal
