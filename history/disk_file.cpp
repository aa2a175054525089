#include "history/disk_file.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <ostream>

#include "history/error.h"
#include "history/file_bytes.h"
#include "history/placement.h"
#include "history/text_fields.h"

namespace voroproof::internal {

namespace {

constexpr std::int64_t kMaxId = std::int64_t{1} << 40;

class DiskFileReader {
 public:
  explicit DiskFileReader(const std::string& path) : path_(path), lines_(path) {
    lines_.source().keep_digest();
  }

  DiskFile read() {
    while (lines_.next() && lines_.line().starts_with('#')) {
    }
    const std::int64_t circles = lines_.integer(0, "number of circles", 1, max_disks + 1);
    for (std::int64_t k = 0; k < circles; ++k) {
      if (!lines_.next()) {
        lines_.fail("", "the file ends after " + std::to_string(k) + " of " +
                            std::to_string(circles) + " circles");
      }
      read_circle();
    }
    if (lines_.next()) lines_.fail("", "text after the last circle");
    if (lines_.offset() > static_cast<std::int64_t>(max_scene_bytes)) {
      throw InputError(path_, 0, "", "larger than " + std::to_string(max_scene_bytes) + " bytes");
    }
    if (!container_seen_) throw InputError(path_, 0, "", "no container: no circle with id < 0");
    DiskFile file = sorted();
    file.scene.sha256 = lines_.source().content_sha256();
    if (const auto fault = find_placement_fault(file.scene)) {
      throw InputError(path_, lines_of_[fault->disk],
                       "disk " + std::to_string(file.ids[fault->disk]), fault->reason);
    }
    return file;
  }

 private:
  double value(std::size_t k, const char* name) {
    const double x = lines_.number(k, name);
    if (x != 0 && (std::fabs(x) > max_scene_value || std::fabs(x) < min_scene_value)) {
      lines_.fail(name, "beyond the limits of a scene: 0 or 1e-100 to 1e100 in magnitude");
    }
    return x;
  }

  void read_circle() {
    const std::int64_t id = lines_.integer(0, "id", -kMaxId, kMaxId);
    const double x = value(1, "x"), y = value(2, "y"), r = value(3, "r");
    if (r < 0) lines_.fail("r", "negative");
    const double vx = value(7, "vx"), vy = value(8, "vy");
    if (id < 0) {
      if (container_seen_) lines_.fail("id", "a second container, which is not supported");
      if (r == 0) lines_.fail("r", "not positive");
      if (vx != 0 || vy != 0) lines_.fail("vx", "a container that moves is not supported");
      container_seen_ = true;
      scene_.cx = to_rational(x);
      scene_.cy = to_rational(y);
      scene_.container_radius = to_rational(r);
      return;
    }
    DiskInput disk;
    disk.x = x;
    disk.y = y;
    disk.radius = r;
    disk.vx = vx;
    disk.vy = vy;
    disk.mass = square(disk.radius);
    scene_.disks.push_back(std::move(disk));
    ids_.push_back(id);
    lines_of_.push_back(lines_.number());
  }

  DiskFile sorted() {
    std::vector<std::size_t> order(ids_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [this](std::size_t a, std::size_t b) { return ids_[a] < ids_[b]; });
    DiskFile file;
    file.scene = scene_;
    file.scene.law = ContainerLaw::whole;
    std::vector<std::int64_t> lines;
    for (std::size_t k = 0; k < order.size(); ++k) {
      const std::size_t from = order[k];
      if (k > 0 && ids_[from] == file.ids.back()) {
        throw InputError(path_, lines_of_[from], "id", "given to two disks");
      }
      file.ids.push_back(ids_[from]);
      file.scene.disks[k] = scene_.disks[from];
      lines.push_back(lines_of_[from]);
    }
    lines_of_ = std::move(lines);
    return file;
  }

  const std::string& path_;
  FieldLines lines_;
  Scene scene_;
  bool container_seen_ = false;
  std::vector<std::int64_t> ids_, lines_of_;
};

}  // namespace

bool is_disk_file(const std::string& path) {
  const std::string beginning = file_bytes(path, 4096, true);
  const std::size_t first = beginning.find_first_not_of(" \t\r\n");
  return first != std::string::npos &&
         (beginning[first] == '#' || (beginning[first] >= '0' && beginning[first] <= '9'));
}

DiskFile read_disk_file(const std::string& path) { return DiskFileReader(path).read(); }

}  // namespace voroproof::internal
