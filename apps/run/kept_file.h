// The file in which a run of `simulate` keeps what it takes to go on (docs/formats.md, section 20).
#pragma once

#include <optional>
#include <string>

#include "history/history_file.h"
#include "kinetic/kept_run.h"

namespace voroproof::internal {

inline constexpr const char* kept_format = "voroproof-kept-run";
inline constexpr const char* kept_ending = ".kept";

struct KeptFile {
  KeptRun run;
  OutputFile::Written history;  // its beginning, up to which the run is kept

  HistoryCounts counts() const;
};

// `header`: of the run's history, without the diagram.
std::string kept_text(const KeptFile& kept, const HistoryHeader& header);

// Nothing where there is no such file, where it is damaged, and where it is of another run.
std::optional<KeptFile> read_kept(const std::string& path, const HistoryHeader& header, int disks);

}  // namespace voroproof::internal
