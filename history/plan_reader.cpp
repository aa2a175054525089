#include "history/plan_file.h"

#include "history/error.h"
#include "history/file_bytes.h"
#include "history/format_version.h"
#include "history/json_reader.h"
#include "history/scene_value.h"

namespace voroproof::internal {
namespace {

constexpr auto bit = JsonReader::bit;

class PlanReader {
 public:
  PlanReader(std::string_view bytes, const std::string& file) : file_(file), json_(bytes, file) {}

  PlanTask read() {
    enum { format, version, name, container, arrive, clearance, vehicles };
    static constexpr std::array<std::string_view, 7> names = {
        "format", "version", "name", "container", "arrive", "clearance", "vehicles"};
    constexpr std::uint32_t required =
        bit(format) | bit(version) | bit(container) | bit(arrive) | bit(vehicles);
    json_.object(names, required, [&](std::size_t member) {
      switch (member) {
        case format:
          if (json_.text() != "voroproof-plan") json_.fail("not \"voroproof-plan\"");
          break;
        case version:
          read_version(json_);
          break;
        case name:
          task_.name = json_.text();
          break;
        case container:
          read_container();
          break;
        case arrive:
          task_.arrive = scene_value(json_);
          if (task_.arrive <= 0) json_.fail("not positive");
          break;
        case clearance:
          read_length(task_.clearance);
          break;
        case vehicles:
          json_.array([&](std::size_t i) { read_vehicle(i); });
          break;
      }
    });
    json_.finish();
    for (std::size_t i = 0; i < lines_.size(); ++i) check_place(i);
    return std::move(task_);
  }

 private:
  void read_point(Point2& p) {
    json_.array_of<2>([&](std::size_t i) { (i == 0 ? p.x : p.y) = scene_value(json_); });
  }

  void read_length(Rational& length) {
    length = scene_value(json_);
    if (length < 0) json_.fail("negative");
  }

  void read_container() {
    enum { center, radius };
    static constexpr std::array<std::string_view, 2> names = {"center", "radius"};
    json_.object(names, bit(center) | bit(radius), [&](std::size_t member) {
      if (member == center)
        read_point(task_.container_center);
      else
        read_length(task_.container_radius);
    });
  }

  void read_vehicle(std::size_t index) {
    if (index >= max_disks) json_.fail("more than " + std::to_string(max_disks) + " vehicles");
    enum { id, radius, start, goal };
    static constexpr std::array<std::string_view, 4> names = {"id", "radius", "start", "goal"};
    Vehicle vehicle;
    json_.array_is_next();  // moves to the value, for its line
    lines_.push_back(json_.line());
    json_.object(names, bit(id) | bit(radius) | bit(start) | bit(goal), [&](std::size_t member) {
      switch (member) {
        case id:
          if (json_.integer(0, max_disks - 1) != static_cast<std::int64_t>(index))
            json_.fail("not " + std::to_string(index) + ": vehicles are listed by id from 0");
          break;
        case radius:
          read_length(vehicle.radius);
          break;
        case start:
          read_point(vehicle.start);
          break;
        case goal:
          read_point(vehicle.goal);
      }
    });
    task_.vehicles.push_back(std::move(vehicle));
  }

  // A straight way between two places inside the container is inside.
  void check_place(std::size_t i) const {
    const Vehicle& vehicle = task_.vehicles[i];
    const Rational room = task_.container_radius - vehicle.radius;
    for (const auto& [place, member] :
         {std::pair(&vehicle.start, ".start"), std::pair(&vehicle.goal, ".goal")}) {
      const Rational x = place->x - task_.container_center.x,
                     y = place->y - task_.container_center.y;
      if (room <= 0 || x * x + y * y >= room * room)
        throw InputError(file_, lines_[i], "vehicles[" + std::to_string(i) + ']' + member,
                         "not strictly inside the container");
    }
  }

  const std::string& file_;
  JsonReader json_;
  PlanTask task_;
  std::vector<std::int64_t> lines_;  // lines of the vehicles' opening braces
};

}  // namespace

PlanTask parse_plan(std::string_view bytes, const std::string& file_name) {
  return of_this_version(bytes, file_name, "voroproof-plan",
                         [&] { return PlanReader(bytes, file_name).read(); });
}

PlanTask read_plan(const std::string& path) {
  return parse_plan(file_bytes(path, max_scene_bytes), path);
}

}  // namespace voroproof::internal
