#include "library/movie/movie.h"

#include <bit>
#include <cmath>
#include <nlohmann/json.hpp>
#include <type_traits>

#include "library/html.h"
#include "library/movie/movie_page.h"
#include "library/palette.h"

namespace voroproof::internal {
namespace {

using Json = nlohmann::ordered_json;

Json palette_json() {
  Json colours = Json::array();
  for (const Colour& c : palette) {
    Json components = Json::array();
    for (const double x : {c.red, c.green, c.blue}) components.push_back(std::lround(255 * x));
    colours.push_back(std::move(components));
  }
  return colours;
}

Json generator_json(const DrawnGenerator& g) {
  return {{"id", g.id},          {"x", g.center[0]},    {"y", g.center[1]},
          {"vx", g.velocity[0]}, {"vy", g.velocity[1]}, {"radius", g.radius}};
}

Json report_json(const Explanation& report, const MovieData& data) {
  const std::string& verdict = report.verdict.verdict;
  Json j{{"verdict", verdict.substr(0, verdict.find(' '))},
         {"words", verdict},
         {"about", report.verdict.about},
         {"reservations", report.verdict.reservations},
         {"reason", report.reason},
         {"prefixEvents", report.prefix_events},
         {"prefixT", report.prefix_t}};
  if (report.fault) {
    j["fault"] = {{"kind", report.fault->kind},
                  {"line", report.fault->line},
                  {"t", report.fault->t},
                  {"truth", report.fault->truth}};
    if (data.event_at_line) j["fault"]["event"] = *data.event_at_line;
  }
  if (!report.generators.empty()) {
    Json generators = Json::array();
    for (const DrawnGenerator& g : report.generators) generators.push_back(generator_json(g));
    j["evidence"] = {{"t", report.generators_t}, {"generators", std::move(generators)}};
  }
  return j;
}

Json facts_json(const Claim& claim, const MovieData& data, const Explanation* report,
                const MovieOptions& options) {
  const Scene& scene = claim.scene;
  Json j{{"name", scene.name},
         {"pageBy", options.producer},
         {"historyBy", claim.history->header().producer},
         {"container",
          {{"x", round_nearest(scene.cx)},
           {"y", round_nearest(scene.cy)},
           {"radius", round_nearest(scene.container_radius)}}},
         {"begin", data.begin},
         {"leftOut", data.left_out},
         {"end", data.end},
         {"cut", data.cut},
         {"remarks", data.remarks},
         {"palette", palette_json()}};
  if (data.stop) j["stop"] = {{"t", data.stop->t}, {"reason", data.stop->reason}};
  if (!data.no_initial.empty()) j["noInitial"] = data.no_initial;
  if (!data.no_diagram.empty()) j["noDiagram"] = data.no_diagram;
  if (options.follow) j["follow"] = *options.follow;
  if (report != nullptr) j["report"] = report_json(*report, data);
  return j;
}

// The element of the page that holds an array, in bytes as the page's typed arrays read them. The
// page's machine has the least significant byte first, as all have on which browsers run.
template <class T>
std::string array_element(const char* name, const std::vector<T>& values) {
  static_assert(std::endian::native == std::endian::little && std::is_trivially_copyable_v<T>);
  const std::string_view bytes(reinterpret_cast<const char*>(values.data()),
                               values.size() * sizeof(T));
  return std::string("<script type=\"text/plain\" id=\"movie-") + name + "\">" + base64(bytes) +
         "</script>\n";
}

std::string title(const Scene& scene) {
  return scene.name.empty() ? std::to_string(scene.disks.size()) + " moving disks" : scene.name;
}

}  // namespace

void make_movie(const Claim& claim, const MovieData& data, const Explanation* report,
                const MovieOptions& options, const std::function<void(std::string_view)>& take) {
  take(page_begin(movie_page, title(claim.scene)));
  take(json_element("movie-facts", facts_json(claim, data, report, options)));
  take(array_element("disks", data.disks));
  take(array_element("initial", data.initial));
  take(array_element("times", data.times));
  take(array_element("kinds", data.kinds));
  take(array_element("ids", data.ids));
  take(array_element("velocities", data.velocities));
  take(page_end(movie_page));
}

}  // namespace voroproof::internal
