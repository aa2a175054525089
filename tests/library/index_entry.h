// An entry of an index (docs/formats.md, section 19), read as it stands.
#pragma once

#include <nlohmann/json.hpp>

#include "certify/fingerprint.h"
#include "certify/replay.h"
#include "certify/shard.h"
#include "history/error.h"

namespace voroproof::internal::testing {

// The cut of the entry, with its state. Throws nlohmann::json::exception where a field is missing
// or of another type.
inline IndexedCut cut_of(const nlohmann::ordered_json& entry) {
  const nlohmann::ordered_json& c = entry.at("cut");
  const std::string digest = c.at("digest");
  std::optional<Sha256> before = Sha256::resumed(digest, c.at("offset"));
  return {.cut = {.part = c.at("part"),
                  .t = c.at("t"),
                  .claims = {c.at("flips"), c.at("collisions"), c.at("maneuvers")},
                  .line = c.at("line"),
                  .offset = c.at("offset"),
                  .header_sha256 = {},
                  .bytes_sha256 = before ? before->hex() : "",
                  .state_sha256 = c.at("state_sha256")},
          .digest = digest,
          .state = entry.at("state").dump(),
          .file = "a.index",
          .line = 1};
}

// The entry with the hash of its own state. Throws InputError where the state is none of this
// scene, and as cut_of().
inline nlohmann::ordered_json with_hash_of_state(nlohmann::ordered_json entry, const Scene& scene,
                                                 const CertifyOptions& options) {
  Replay replay(scene, options);
  try {
    replay.read(cut_of(entry));
  } catch (const InputError& other) {
    if (other.field() != "cut.state_sha256") throw;
  }
  Fingerprint state;
  replay.add_to(state);
  entry["cut"]["state_sha256"] = state.hex();
  return entry;
}

}  // namespace voroproof::internal::testing
