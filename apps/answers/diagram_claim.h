// Claims about diagrams at rest, from the files of any program.
#pragma once

#include <optional>
#include <string>

#include "voroproof/certify_diagram.h"

namespace voroproof::internal {

struct DiagramFiles {
  DiagramClaim claim;
  // The hash of the bytes that were read; with two files both hashes, with a blank between.
  std::string sha256;
};

// A file as `voroproof diagram` writes it (.json), of which edges, vertices and hidden disks may be
// missing, and which may have "neighbours": pairs of generators. Throws InputError.
DiagramFiles read_diagram_claim(const std::string& path);

// A table of disks (history/disk_table.h), and a list of edges: on each line the four generators of
// an edge, or the two of a pair of neighbours, between commas, semicolons, tabs or blanks. A first
// line that has no digit is a heading. Throws InputError.
DiagramFiles read_diagram_claim(const std::string& table, const std::string& edges,
                                const std::optional<Circle>& frame,
                                const std::optional<Box>& walls);

}  // namespace voroproof::internal
