// A movie in a browser, and what the program computes of the same history.
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "history/diagram_file.h"
#include "tests/apps/verbs/browser.h"

namespace voroproof::internal {

class Movie : public Cli, protected Browser {
 protected:
  void SetUp() override { require_browser(); }

  std::string simulated(const std::string& scene) const {
    const std::string path = file("a.history.jsonl");
    must({"simulate", scene, "-o", path, "--quiet"});
    return path;
  }

  std::string movie(const std::string& scene, const std::string& history,
                    const Arguments& more = {}) const {
    Arguments arguments{"movie", scene, history, "-o", file("a.html")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    must(arguments);
    return file("a.html");
  }

  DiagramFile diagram(const std::string& scene, const std::string& history, double t) const {
    must({"snapshot", scene, history, "--at", Json(t).dump(), "-o", file("a.diagram.json")});
    return read_diagram(file("a.diagram.json"));
  }

  std::string scene_file(const std::string& disks, const std::string& more = "") const {
    return directory_.write(
        "a.scene.json",
        R"({"format":"voroproof-scene","version":1,"container":{"center":[1,2],"radius":10},)"
        R"("horizon":20,)" +
            more + "\"disks\":[" + disks + "]}\n");
  }

  // The page, sought to these times one after the other, must have the edges, the vertices and the
  // centres that the program has.
  void expect_same(const std::string& scene, const std::string& history,
                   const std::vector<double>& times, const Arguments& more = {}) {
    const Json page = run_in_page(movie(scene, history, more), R"js(
      return TIMES.map((t) => {
        player.seek(t);
        player.draw();
        const { diagram } = player.replay, { vertices } = player.painter;
        const { x, y, radius } = player.data.frame;
        const edges = [], circles = [];
        for (let h = 0; h < diagram.halves; h += 2) {
          edges.push(diagram.quad(h).map((site) => site - 1));
        }
        for (let h = 0; h < diagram.halves; ++h) {
          circles.push([[h, diagram.next[h], diagram.next[diagram.next[h]]]
            .map((side) => diagram.org[side] - 1),
            x + radius * vertices.x[h], y + radius * vertices.y[h], radius * vertices.radius[h]]);
        }
        return { edges, circles, x: Array.from(player.motion.x, (u) => x + radius * u),
          y: Array.from(player.motion.y, (u) => y + radius * u), fault: player.replay.fault, irregular: player.painter.curves.irregular };
      });)js",
                                  times);
    ASSERT_EQ(page.at("errors"), Json::array());
    for (std::size_t k = 0; k < times.size(); ++k) {
      const DiagramFile truth = diagram(scene, history, times[k]);
      expect_same(page.at("result").at(k), truth);
      if (HasFailure()) FAIL() << "t = " << times[k];
    }
  }

  // The same with the times put into the script.
  Json run_in_page(const std::string& page, const std::string& script,
                   const std::vector<double>& times) {
    return Browser::run_in_page(page, "const TIMES = " + Json(times).dump() + ";" + script);
  }
  using Browser::run_in_page;

  void expect_same(const Json& shown, const DiagramFile& truth) {
    EXPECT_EQ(shown.at("fault"), Json());
    EXPECT_EQ(shown.at("irregular"), 0);
    std::set<Quad> edges;
    for (const Json& q : shown.at("edges")) {
      edges.insert(canonical(Quad{q.at(0), q.at(1), q.at(2), q.at(3)}));
    }
    EXPECT_EQ(edges, std::set<Quad>(truth.edges.begin(), truth.edges.end()));
    const double near = 1e-7 * truth.container_radius;
    std::map<Triple, DiagramVertex> vertices;
    for (const DiagramVertex& v : truth.vertices) vertices.emplace(v.generators, v);
    EXPECT_EQ(shown.at("circles").size(), 3 * vertices.size());
    for (const Json& c : shown.at("circles")) {
      const Json& g = c.at(0);
      const auto found = vertices.find(canonical(Triple{g.at(0), g.at(1), g.at(2)}));
      ASSERT_NE(found, vertices.end()) << c;
      EXPECT_NEAR(c.at(1), found->second.center[0], near) << c;
      EXPECT_NEAR(c.at(2), found->second.center[1], near) << c;
      EXPECT_NEAR(c.at(3), found->second.radius, near) << c;
    }
    for (std::size_t i = 0; i < truth.disks.size(); ++i) {
      EXPECT_NEAR(shown.at("x").at(i + 1), truth.disks[i].center[0], near);
      EXPECT_NEAR(shown.at("y").at(i + 1), truth.disks[i].center[1], near);
    }
  }
};

}  // namespace voroproof::internal
