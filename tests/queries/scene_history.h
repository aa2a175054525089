// A scene and its history as files.
#pragma once

#include <string>

#include "apps/run/history_sink.h"
#include "history/history_writer.h"
#include "history/scene.h"
#include "library/maneuver_input.h"
#include "tests/history/temporary_directory.h"
#include "tests/support/scene_run.h"

namespace voroproof::internal::testing {

struct SceneHistory {
  // Runs the exact engine, which must not stop early.
  explicit SceneHistory(const Scene& given) {
    scene = read_scene(directory.write("scene", text(given)));
    HistoryWriter writer(history);
    HistorySink sink(writer, {scene.sha256, scene.horizon, "test", {}, {}},
                     static_cast<int>(scene.disks.size()));
    Engine engine(motion_input(scene), maneuver_input(scene), {});
    complete = engine.run(sink).kind == Outcome::Kind::complete;
    if (!complete) return;
    writer.end();
    writer.close();
  }

  TemporaryDirectory directory;
  Scene scene;
  std::string history = directory.file("history");
  bool complete = false;
};

}  // namespace voroproof::internal::testing
