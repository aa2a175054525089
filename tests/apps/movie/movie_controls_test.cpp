// The movie's controls: clicks, keys, drags and the page's address.
#include <gtest/gtest.h>

#include <string>

#include "tests/apps/movie/movie.h"

namespace voroproof::internal {
namespace {

TEST_F(Movie, ClicksKeysAndDragsMoveIt) {
  const std::string scene = reference(30, "50");
  const std::string history = simulated(scene);
  const Json page = run_in_page(movie(scene, history, {"--follow", "7"}), R"js(
    const { state, data } = player, at = () => [state.t, state.applied, state.selected];
    const press = (key, more) =>
      window.dispatchEvent(new KeyboardEvent("keydown", { key, ...more }));
    const pointer = (canvas, type, x, y) => canvas.dispatchEvent(new PointerEvent(type,
      { clientX: x + canvas.getBoundingClientRect().x, clientY: y +
        canvas.getBoundingClientRect().y, buttons: 1, bubbles: true }));
    const said = {};
    player.draw();
    said.follow = state.follow;
    const rows = document.querySelectorAll("#events .row");
    said.rows = rows.length;
    rows[3].click();
    said.clicked = at();
    press("ArrowRight");
    said.right = at();
    press("ArrowLeft");
    press("ArrowLeft");
    said.left = at();
    press("Home");
    said.home = at();
    press("ArrowRight", { shiftKey: true });
    said.jump = state.t;
    press("End");
    said.end = at();
    press(" ");  // from the start again
    said.playing = [state.playing, state.t];
    player.last = 1000;
    player.tick(1050);
    said.ticked = state.t / state.rate;
    press(" ");
    said.paused = state.playing;
    const strip = element("timeline"), middle = strip.clientWidth / 2;
    pointer(strip, "pointerdown", middle, 20);
    said.dragged = state.t;
    press("+");
    said.rate = state.rate / player.natural;
    press("Escape");
    said.unfollowed = state.follow;
    player.draw();
    const [x, y] = player.view.canvasPoint(player.motion.x[5], player.motion.y[5]);
    pointer(element("picture"), "pointerdown", x, y);
    pointer(element("picture"), "pointerup", x, y);
    said.chosen = state.follow;
    player.draw();
    said.chips = element("neighbours").children.length;
    element("filter").value = "collisions";
    element("filter").dispatchEvent(new Event("change"));
    said.filtered = [...document.querySelectorAll("#events .row.flip")].length;
    said.times = Array.from(data.times.subarray(0, 6));
    return said;)js");
  ASSERT_EQ(page.at("errors"), Json::array());
  const Json& said = page.at("result");
  const Json& times = said.at("times");
  EXPECT_EQ(said.at("follow"), 7);
  EXPECT_GT(said.at("rows"), 8);
  EXPECT_EQ(said.at("clicked"), Json::array({times.at(3), 4, 3}));
  EXPECT_EQ(said.at("right"), Json::array({times.at(4), 5, 4}));
  EXPECT_EQ(said.at("left"), Json::array({times.at(2), 3, 2}));
  EXPECT_EQ(said.at("home"), Json::array({0, 0, nullptr}));
  EXPECT_EQ(said.at("jump"), 0.5);
  EXPECT_EQ(said.at("end").at(0), 50);
  EXPECT_EQ(said.at("playing"), Json::array({true, 0}));
  EXPECT_NEAR(said.at("ticked"), 0.05, 1e-9);
  EXPECT_EQ(said.at("paused"), false);
  EXPECT_NEAR(said.at("dragged"), 25, 0.1);
  EXPECT_EQ(said.at("rate"), 2);
  EXPECT_EQ(said.at("unfollowed"), Json());
  EXPECT_EQ(said.at("chosen"), 4);
  EXPECT_GE(said.at("chips"), 2);
  EXPECT_EQ(said.at("filtered"), 0);
}

// Two events at one instant are stepped through one by one, and both have happened at its time.
TEST_F(Movie, EventsOfOneInstantAreSteppedThroughOneByOne) {
  const std::string scene = scene_file(
      R"({"center":[-3,2],"radius":1,"velocity":[1,0]},{"center":[5,2],"radius":1,"velocity":[-1,0]},)"
      R"({"center":[1,7],"radius":1,"velocity":[0,1]})");
  const Json page = run_in_page(movie(scene, simulated(scene)), R"js(
    const { data, state } = player;
    const k = data.times.findIndex((t, k) => k > 0 && t === data.times[k - 1]);
    player.look(k - 1);
    const one = state.applied;
    player.step(1);
    const two = state.applied;
    player.seek(data.times[k]);
    return { k, one, two, all: state.applied };)js");
  ASSERT_EQ(page.at("errors"), Json::array());
  const Json& result = page.at("result");
  const int k = result.at("k");
  ASSERT_GT(k, 0);
  EXPECT_EQ(result.at("one"), k);
  EXPECT_EQ(result.at("two"), k + 1);
  EXPECT_GE(result.at("all"), k + 1);
}

TEST_F(Movie, AnAddressOpensItAtAPlace) {
  const std::string scene = reference(10, "30");
  const std::string page = movie(scene, simulated(scene), {"--horizon", "20"});
  const std::string script =
      "return [player.data.end, player.state.t, player.state.applied, player.state.follow, "
      "player.data.times[1], player.data.times.at(-1), innerHeight - "
      "element('picture').clientHeight];";
  Json said = run_in_page(page, script, "#t=12.5&follow=3").at("result");
  EXPECT_EQ(said.at(0), 20);
  EXPECT_EQ(said.at(1), 12.5);
  EXPECT_EQ(said.at(3), 3);
  EXPECT_LE(said.at(5), 20);
  // Wide or narrow, the whole window is the picture's.
  for (const char* window : {"1000,700", "600,600"}) {
    said = run_in_page(page, script, "#event=2&bare", window).at("result");
    EXPECT_EQ(said.at(1), said.at(4));
    EXPECT_EQ(said.at(2), 2);
    EXPECT_EQ(said.at(6), 0) << window;
  }
}

}  // namespace
}  // namespace voroproof::internal
