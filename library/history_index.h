// An index beside a history (docs/formats.md, section 19): where reading may begin, and the state
// there.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "certify/certifier.h"
#include "certify/replay.h"
#include "certify/shard.h"
#include "history/claim.h"
#include "library/queries/recorded_moment.h"

namespace voroproof::internal {

// Writes the index of the claim's history, a plain JSON file of which nothing has been read yet,
// for certifications with these options, and returns the number of its entries. What the claims say
// is taken at its word. Throws InputError where the history is not of its form or no plain file,
// CertificationInterrupted where the monitor of the options says so.
std::int64_t write_index(const std::string& path, const std::string& producer, Claim& claim,
                         const std::string& history_path, const CertifyOptions& options);

// The content of an index about one cut.
struct IndexEntry {
  IndexedCut at;
  // Whether every claim before the cut that turns a disk has its `v`.
  bool told = false;
};

// An index, which is to be by this program.
struct IndexFile {
  std::string path, producer;
};

// The last entry of the index whose cut `is_early`, which holds of none behind one of which it does
// not hold; nothing where it holds of none. Nothing of an entry is proved: that it is of this file
// and whole is checked by hashes, which whoever writes an index may choose. Throws InputError where
// the index is no index, is of another version of the program, of another history, or of another
// tolerance or orientation than the options'; and where the bytes of the history up to the next
// entry are not those of which it was made. Without options any tolerance will do.
std::optional<IndexEntry> find_entry(const IndexFile& index, const Scene& scene,
                                     const HistoryHeader& header, const std::string& history_path,
                                     const CertifyOptions* options,
                                     const std::function<bool(const Cut&)>& is_early);

// The last cut of the index that is certainly no later than that at which the task's first part
// begins; nothing where there is none. Throws as find_entry().
std::optional<IndexedCut> find_start(const IndexFile& index, const Claim& claim,
                                     const std::string& history_path, const CertifyOptions& options,
                                     const ShardTask& task);

// The last entry of the index whose cut is certainly before t, at which the history, of which
// nothing has been read yet, goes on; nothing where there is no such entry. Throws as find_entry(),
// but the index may be of any tolerance.
std::optional<IndexEntry> go_on_before(const IndexFile& index, const Scene& scene,
                                       HistorySource& history, const std::string& history_path,
                                       const Rational& t);

// The same; returns what is recorded there, which is taken at its word.
std::optional<RecordedMoment> start_at_entry(const IndexFile& index, const Scene& scene,
                                             HistorySource& history,
                                             const std::string& history_path, const Rational& t);

}  // namespace voroproof::internal
