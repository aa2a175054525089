// The page that plays a history, by the library's headers alone; what is in it is tested with the
// program's (tests/apps/movie).
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "tests/library/scenes.h"
#include "voroproof/voroproof.h"

namespace {

using namespace voroproof;
using namespace voroproof::internal::testing;

TEST(MoviePage, HoldsTheHistoryAndTheReport) {
  const Scene scene = reference(6, 20);
  History history = simulate(scene);
  const std::string page = movie_page(scene, history);
  EXPECT_EQ(page.rfind("<!DOCTYPE html>", 0), 0u);
  EXPECT_EQ(page, movie_page(scene, history));
  EXPECT_EQ(page.find("\"verdict\":\""), std::string::npos);
  EXPECT_EQ(page.find("\"follow\":"), std::string::npos);

  history.events.erase(history.events.begin());
  const Report report = certify(scene, history);
  const std::string told = movie_page(scene, history, {4, &report});
  EXPECT_NE(told.find("\"follow\":4"), std::string::npos);
  EXPECT_NE(told.find("\"verdict\":\"REFUTED\""), std::string::npos);
}

// Nothing of a flip is shown as if it had been judged.
TEST(MoviePage, OfAReportOnCollisionsAlone) {
  const Scene scene = reference(6, 20);
  const History history = simulate(scene);
  CertifyOptions options;
  options.events = EventKinds::collisions;
  const Report report = certify(scene, history, options);
  EXPECT_EQ(report.words, "CERTIFIED (collisions alone)");
  EXPECT_EQ(report.about.rfind("collisions and maneuvers, exact truth, up to t = 20", 0), 0u);
  ASSERT_EQ(report.reservations.size(), 1u);
  const std::string page = movie_page(scene, history, {{}, &report});
  EXPECT_NE(page.find("\"words\":\"CERTIFIED (collisions alone)\""), std::string::npos);
  EXPECT_NE(page.find("\"noDiagram\":"), std::string::npos);
  EXPECT_NE(page.find("id=\"movie-initial\"></script>"), std::string::npos);
}

TEST(MoviePage, OfSmallScenes) {
  for (const int n : {0, 1, 2}) {
    const Scene scene = reference(n, 5);
    EXPECT_NE(movie_page(scene, simulate(scene)).find("movie-velocities"), std::string::npos) << n;
  }
}

TEST(MoviePage, RefusesWhatDoesNotBelongTogether) {
  const Scene scene = reference(6, 20), other = reference(6, 20, 2);
  const History history = simulate(scene);
  EXPECT_THROW(movie_page(other, history), InputError);
  const Report report = certify(other, simulate(other));
  EXPECT_THROW(movie_page(scene, history, {{}, &report}), InputError);
  // Of this scene and another history: of one event less, or by another version.
  Report right = certify(scene, history);
  EXPECT_NE(movie_page(scene, history, {{}, &right}).find("\"words\":\"CERTIFIED\""),
            std::string::npos);
  History wrong = history;
  wrong.events.pop_back();
  EXPECT_THROW(movie_page(scene, wrong, {{}, &right}), InputError);
  right.json.replace(right.json.find("voroproof 0"), 11, "voroproof 9");
  EXPECT_THROW(movie_page(scene, history, {{}, &right}), InputError);
  EXPECT_THROW(movie_page(scene, history, {6, nullptr}), std::invalid_argument);
  EXPECT_THROW(movie_page(scene, history, {-1, nullptr}), std::invalid_argument);
}

}  // namespace
