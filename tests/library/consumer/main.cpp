// Simulates, certifies, spoils the history, and asks for the diagram at a time.
#include <voroproof/voroproof.h>
#include <cstdio>

int main() {
  voroproof::ReferenceOptions options;
  options.n = 20;
  options.horizon = 50;
  voroproof::Scene scene = voroproof::reference_scene(options);
  scene.disks[0].vx = voroproof::Number("1/3");

  voroproof::History history = voroproof::simulate(scene);
  const voroproof::Report right = voroproof::certify(scene, history);
  std::printf("%zu events, %s\n", history.events.size(), voroproof::name(right.verdict));

  history.events.erase(history.events.begin() + 5);
  const voroproof::Report wrong = voroproof::certify(scene, history);
  std::printf("without one: %s, %s\n", voroproof::name(wrong.verdict), wrong.reason.c_str());

  const voroproof::Diagram diagram = voroproof::diagram_at(scene, voroproof::Number("25/2"));
  std::printf("t = %s: %zu vertices, %zu edges, disk 0 has %zu neighbours\n",
              diagram.t.text().c_str(), diagram.vertices.size(), diagram.edges.size(),
              voroproof::neighbours(diagram, 0).size());
  try {
    scene.disks[1].x = scene.disks[0].x;
    scene.disks[1].y = scene.disks[0].y;
    voroproof::simulate(scene);
  } catch (const voroproof::InputError& error) {
    std::printf("%s\n", error.what());
  }

  return right.verdict == voroproof::Verdict::certified &&
                 wrong.verdict == voroproof::Verdict::refuted && diagram.edges.size() == 57
             ? 0
             : 1;
}
