#include "history/disk_writer.h"

#include <ostream>
#include <string>

#include "history/json_text.h"

namespace voroproof::internal {

void write_disk_file(std::ostream& out, const Scene& scene) {
  const auto text = [](const Rational& q, const std::string& what) {
    const double x = round_nearest(q);
    if (to_rational(x) != q) throw UnsuitableScene(what + " is no binary64");
    return number_text(x);
  };
  out << "# BCF Ver 2.1\n" << scene.disks.size() + 1 << '\n';
  out << "-1\t" << text(scene.cx, "container.center[0]") << '\t'
      << text(scene.cy, "container.center[1]") << '\t'
      << text(scene.container_radius, "container.radius") << "\t0.5\t0.5\t0.5\t0\t0\n";
  for (std::size_t k = 0; k < scene.disks.size(); ++k) {
    const DiskInput& d = scene.disks[k];
    const std::string name = "disks[" + std::to_string(k) + "]";
    if (d.mass != square(d.radius)) {
      throw UnsuitableScene(name + ".mass is not the radius squared");
    }
    out << k << '\t' << text(d.x, name + ".center[0]") << '\t' << text(d.y, name + ".center[1]")
        << '\t' << text(d.radius, name + ".radius") << "\t0.5\t0.5\t0.5\t"
        << text(d.vx, name + ".velocity[0]") << '\t' << text(d.vy, name + ".velocity[1]") << '\n';
  }
}

}  // namespace voroproof::internal
