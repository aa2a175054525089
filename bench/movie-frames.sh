#!/usr/bin/env bash
# What a frame of a movie costs in chromium without a graphics processor, in milliseconds: medians
# over 120 frames spread over the whole time. Run it on an otherwise idle machine.
#
# usage: bench/movie-frames.sh PAGE.html
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
{
  cat "$1"
  cat <<'PAGE'
<script>{
  const { painter, state, data, motion, replay } = player, lines = [];
  const measure = (what, action) => {
    const times = [];
    for (let k = 0; k < 120; ++k) {
      player.seek(data.end * k / 120);
      const from = performance.now();
      action();
      times.push(performance.now() - from);
    }
    lines.push(`${times.sort((a, b) => a - b)[60].toFixed(1)} ms  ${what}`);
  };
  player.draw();
  measure("positions and replay", () => {
    motion.moveTo(state.t);
    replay.moveTo(state.applied);
  });
  measure("these, vertices and edges", () => {
    motion.moveTo(state.t);
    replay.moveTo(state.applied);
    painter.computeEdges();
  });
  measure("these and the calls that draw", () => painter.paint(state));
  measure("these and the pixels", () => {
    painter.paint(state);
    painter.context.getImageData(0, 0, 1, 1);
  });
  document.body.textContent = `BEGIN\n${lines.join("\n")}\nEND`;
}</script>
PAGE
} >"$work/page.html"
timeout 120 chromium --headless --no-sandbox --disable-gpu --disable-dev-shm-usage --user-data-dir="$work/profile" \
  --window-size=1400,900 --dump-dom "file://$work/page.html" 2>/dev/null | sed -n '/BEGIN/,/END/p' |
  grep ' ms '
