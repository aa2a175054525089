// Tables of disks at rest: one a line, with named columns or without a heading.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace voroproof::internal {

struct TableDisk {
  double x = 0, y = 0, radius = 0;
};

struct DiskTable {
  std::vector<TableDisk> disks;
  // The other columns: name and values.
  std::vector<std::pair<std::string, std::vector<std::string>>> rest;
  std::string sha256;  // the hash of the bytes that were read
};

// Fields are separated by commas, semicolons or tabs, or else by blanks; a field may stand in
// double quotes. A heading names the columns: x (lon, longitude, easting), y (lat, latitude,
// northing), and radius (r, weight, w), without which all radii are 0; other columns are kept.
// Without a heading the first two or three are x, y and radius. Lines that are empty, or begin with
// "#", say nothing. A number is a decimal and denotes the nearest binary64.
// Throws InputError.
DiskTable read_disk_table(const std::string& path);

}  // namespace voroproof::internal
