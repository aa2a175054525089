// Disk files ("BCF"): disks in a container as the engine of the paper's authors reads them
// (docs/formats.md). They have no masses, no restitution, no horizon and no maneuvers; the mass of
// a disk is its radius squared, that of a point is 0.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "history/scene.h"

namespace voroproof::internal {

struct DiskFile {
  Scene scene;  // restitution 1, horizon 0; container_law "whole", as that engine has it
  std::vector<std::int64_t> ids;  // ids[k]: what the file calls disk k; ascending
};

// Whether the file begins as disk files and event sequences do, after white space: with a comment
// or a number. Whatever else is no JSON object is for the reader of JSON to refuse.
bool is_disk_file(const std::string& path);

// Reads and checks a disk file as read_scene does a scene. Throws InputError.
DiskFile read_disk_file(const std::string& path);

}  // namespace voroproof::internal
