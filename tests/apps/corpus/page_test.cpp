// The page of a run over the corpus: the data in it, and what a browser shows of them.
#include <cstdio>
#include <stdexcept>

#include "tests/apps/verbs/browser.h"
#include "tests/apps/verbs/corpus_cli.h"

namespace voroproof::internal {
namespace {

// Names, tags and messages as someone might choose them who means harm.
const std::string hostile = R"(</script><b>&amp;"'<img src=x onerror="hurt=1">)";
const std::string hostile_name = R"(<b>&amp;"'<img src=x onerror="hurt=1">)";

class CorpusPage : public CorpusCli {
 protected:
  std::string page(Arguments more) const {
    more.insert(more.end(), {"--html", file("r.html")});
    run_corpus(more);
    return file("r.html");
  }

  // A program that crashes, says a thing, errs and does it right, by the number of disks.
  std::string moody() const {
    return "case $(grep -o center {scene} | wc -l) in "
           "4) echo \"last words\" >&2; exit 7;; "
           "9) cp " +
           path("generic/eight/wrong/dropped-flip.history.jsonl") +
           " {history};; "
           "*) " +
           simulate() + ";; esac";
  }

  void change_case(const std::string& name, const std::string& member, const Json& value) const {
    Json description = Json::parse(read_bytes(path(name + "/case.json")));
    description[member] = value;
    write("cases/" + name + "/case.json", description.dump());
  }

  void add_hostile() const {
    add(hostile_name, hostile_name, {"grid", "--n", "4", "--motion", "rest", "--horizon", "1"});
    const std::string name = hostile_name + "/" + hostile_name;
    for (const char* member : {"tags", "truth"}) {
      change_case(name, member, Json::array({hostile}));
    }
    change_case(name, "story", hostile);
  }

  static Json data(const std::string& page) {
    const std::string text = read_bytes(page), element = "id=\"report\">";
    const auto begin = text.find(element) + element.size();
    return Json::parse(text.substr(begin, text.find("</script>", begin) - begin));
  }

  // The page has the data of the JSON file, and these of the cases.
  void expect_data(const std::string& page) const {
    Json found = data(page);
    for (Json& result : found["results"]) {
      const std::string name = result["name"];
      EXPECT_EQ(result["story"], "The story of " + name + ": <b>ties</b> & \"symmetry\".");
      EXPECT_EQ(result["sources"], Json::array({"by hand"}));
      EXPECT_EQ(result.contains("picture"), name != "slide");
      if (name != "slide") {
        EXPECT_EQ(result["picture"].get<std::string>().substr(0, 34),
                  "data:image/svg+xml;base64,PD94bWwg");
      }
      for (const char* member : {"story", "sources", "picture"}) result.erase(member);
    }
    EXPECT_EQ(found["results"].size(), 6u);
    EXPECT_EQ(found, json("report.json"));
  }
};

TEST_F(CorpusPage, HoldsTheReportAndTheCases) {
  expect_data(page({"--against", moody()}));
  expect_data(page({}));
}

TEST_F(CorpusPage, NeedsNothingElseButJavaScript) {
  const std::string text = read_bytes(page({"--case", "three"}));
  for (const char* reference : {"http", " src=", " href=", "@import", "url(", "fetch(", "{{"}) {
    EXPECT_EQ(text.find(reference), std::string::npos) << reference;
  }
  EXPECT_NE(text.find("<noscript>"), std::string::npos);
}

TEST_F(CorpusPage, TextsCannotEndAnElement) {
  add_hostile();
  const std::string text = read_bytes(page({"--against", simulate() + " # " + hostile}));
  EXPECT_NE(text.find("<title>Degenerate cases: "), std::string::npos);
  EXPECT_NE(text.find("&lt;/script&gt;&lt;b&gt;&amp;amp;"), std::string::npos);
  for (const char* element : {"</script><b>", "<b>&", "<img src"}) {
    EXPECT_EQ(text.find(element), std::string::npos) << element;
  }
}

class CorpusPageShown : public CorpusPage, protected Browser {
 protected:
  void SetUp() override {
    require_browser();
    if (!IsSkipped()) CorpusPage::SetUp();
  }

  // All texts that are to be seen, once every case is open; null of what is not there.
  Json shown(const std::string& page) {
    const Json found = run_in_page(page, R"js(
      const all = (root, selector) => Array.from(root.querySelectorAll(selector));
      const texts = (root, selector) => all(root, selector).map((part) => part.textContent);
      const text = (root, selector) => {
        const part = root.querySelector(selector);
        return part && part.getClientRects().length > 0 ? part.textContent : null;
      };
      const rows = (root) => all(root, "tbody tr").map((row) => texts(row, "td"));
      const bar = (root) => all(root.querySelector(".bar"), "i")
        .map((part) => [part.className, Math.round(parseFloat(part.style.width))]);
      for (const details of all(document, "details")) details.open = true;
      const page = { bar: bar(document), title: document.title, legend: text(document, ".legend"),
        hurt: "hurt" in window, images: all(document, "img").length, sections: texts(document, "h2") };
      for (const id of ["subtitle", "command", "passed", "cases", "meaning"]) {
        page[id] = text(document, "#" + id);
      }
      const table = document.getElementById("families");
      page.families = text(document, "#families") === null ? null : all(table, "tbody tr")
        .map((row) => ({ cells: texts(row, "td"), kinds: texts(row, ".kind"), bar: bar(row) }));
      page.heads = texts(table, "th");
      page.results = all(document, "details").map((result) => {
        const picture = result.querySelector("img");
        return { passed: result.className, verdict: text(result, "summary b"),
          style: result.querySelector("summary b").className, name: text(result, ".name"),
          reason: texts(result, ".reason")[0], seconds: text(result, "summary .n"),
          story: text(result, ".story"), tags: texts(result, ".tag"), rows: rows(result),
          paragraphs: texts(result, ".findings p"), sources: texts(result, ".findings li"),
          command: text(result, ".mono"), alt: picture && picture.alt,
          picture: picture && picture.src };
      });
      return page;)js");
    EXPECT_EQ(found.at("errors"), Json::array());
    return found.at("result");
  }

  static Json result_named(const Json& page, const std::string& name) {
    for (const Json& result : page.at("results")) {
      if (result.at("name") == name) return result;
    }
    throw std::out_of_range("the page shows no case " + name);
  }

  static std::string seconds(const Json& value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3f", value.get<double>());
    return text;
  }

  // What is shown of the cases themselves.
  void expect_cases(const Json& page, const Json& data) const {
    EXPECT_EQ(page["sections"], Json::array({"generic", "stops", "ties"}));
    ASSERT_EQ(page["results"].size(), data["results"].size());
    for (std::size_t k = 0; k < page["results"].size(); ++k) {
      const Json &result = page["results"][k], &of = data["results"][k];
      const std::string id = of["family"].get<std::string>() + "/" + of["name"].get<std::string>();
      for (const char* member : {"name", "story", "tags"}) EXPECT_EQ(result[member], of[member]);
      EXPECT_EQ(result["passed"], of["passed"].get<bool>() ? "passed" : "failed") << id;
      EXPECT_EQ(result["command"], "voroproof corpus show " + id);
      EXPECT_EQ(result["picture"], of.value("picture", Json()));
      EXPECT_EQ(result["alt"], of.contains("picture") ? Json(id) : Json());
    }
  }
};

TEST_F(CorpusPageShown, AProgramsResults) {
  const std::string file = page({"--against", moody()});
  const Json found = shown(file), report = data(file);
  expect_cases(found, report);
  EXPECT_EQ(found["title"], "Degenerate cases: " + moody());
  EXPECT_EQ(found["command"], moody());
  EXPECT_EQ(found["subtitle"], "A program run on the corpus; its histories certified by " +
                                   report["producer"].get<std::string>());
  EXPECT_EQ(found["passed"], "4");
  EXPECT_EQ(found["cases"], "of 6 cases passed");
  EXPECT_EQ(found["bar"], Json::parse(R"([["certified",50],["refuted",17],["undecided",17],
                                          ["crashed",17]])"));
  EXPECT_EQ(found["legend"], "certifiedrefutedundecidedinvalidcrashedtimed out");
  EXPECT_EQ(found["meaning"],
            "A history is certified if every event in it is proved, and proved that none is "
            "missing, against the true motion (exact) or against the motion that it records itself "
            "(recorded). Limits for each process: 60 s. The seconds are the program's.");
}

TEST_F(CorpusPageShown, TheTableOfFamilies) {
  const std::string file = page({"--against", moody()});
  const Json found = shown(file), report = data(file);
  EXPECT_EQ(found["heads"],
            Json::array({"family", "", "cases", "exact", "recorded", "refuted", "undecided",
                         "invalid", "crashed", "timed out", "seconds", "refuted for"}));
  const std::vector<Arguments> numbers{{"2", "0", "0", "1", "0", "0", "1", "0"},
                                       {"1", "0", "0", "0", "1", "0", "0", "0"},
                                       {"3", "3", "3", "0", "0", "0", "0", "0"},
                                       {"6", "3", "3", "1", "1", "0", "1", "0"}};
  ASSERT_EQ(found["families"].size(), numbers.size());
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    const Json &row = found["families"][k], &family = report["families"][k];
    Json cells = Json::array({family["family"], ""});
    for (const std::string& number : numbers[k]) cells.push_back(number);
    const bool refuted = family["outcomes"]["refuted"] == 1;
    cells.push_back(seconds(family["seconds"]));
    cells.push_back(refuted ? "missing event 1" : "");
    EXPECT_EQ(row["cells"], cells);
    EXPECT_EQ(row["kinds"].size(), refuted ? 1u : 0u);
  }
  EXPECT_EQ(found["families"][0]["bar"], Json::parse(R"([["refuted",50],["crashed",50]])"));
  EXPECT_EQ(found["families"][2]["bar"], Json::parse(R"([["certified",100]])"));
}

TEST_F(CorpusPageShown, WhatWasFoundOfEachHistory) {
  const std::string file = page({"--against", moody()});
  const Json found = shown(file), report = data(file);
  const Json crashed = result_named(found, "three");
  EXPECT_EQ(crashed["verdict"], "crashed");
  EXPECT_EQ(crashed["style"], "crashed");
  EXPECT_EQ(crashed["reason"], "exit code 7: last words");
  EXPECT_EQ(crashed["rows"], Json::array());
  EXPECT_EQ(crashed["paragraphs"],
            Json::array({"exit code 7: last words", "Last line on stderr: last words"}));
  const Json refuted = result_named(found, "eight");
  const Json &judged = report["results"][0], &exact = judged["exact"];
  ASSERT_EQ(judged["name"], "eight");
  EXPECT_EQ(refuted["verdict"], "refuted");
  EXPECT_EQ(refuted["reason"], judged["reason"]);
  EXPECT_EQ(refuted["seconds"], seconds(judged["program"]["seconds"]) + " s");
  EXPECT_EQ(refuted["paragraphs"], Json::array());
  ASSERT_EQ(refuted["rows"].size(), 2u);
  const Json& row = refuted["rows"][0];
  EXPECT_EQ(row[0], "exact");
  EXPECT_EQ(row[1], "refuted");
  EXPECT_EQ(row[2], exact["reason"]);
  EXPECT_EQ(row[3].get<std::string>().find(exact["certified_prefix"]["events"].dump() +
                                           " events, up to t = "),
            0u);
  EXPECT_EQ(row[4], seconds(exact["seconds"]));
  EXPECT_EQ(refuted["rows"][1][0], "recorded");
  const Json undecided = result_named(found, "slide");
  EXPECT_EQ(undecided["verdict"], "undecided");
  EXPECT_EQ(undecided["paragraphs"][0], undecided["reason"]);
}

TEST_F(CorpusPageShown, TheTruthsThatWereAskedFor) {
  const Json found =
      shown(page({"--against", simulate(), "--truth", "recorded", "--case", "three"}));
  EXPECT_NE(found["meaning"].get<std::string>().find(
                "missing, against the motion that it records itself (recorded). Limits"),
            std::string::npos);
  ASSERT_EQ(found["results"][0]["rows"].size(), 1u);
  EXPECT_EQ(found["results"][0]["rows"][0][0], "recorded");
  EXPECT_EQ(found["results"][0]["rows"][0][1], "certified");
}

TEST_F(CorpusPageShown, TheCorpusAgainstItself) {
  Json wrong = Json::parse(read_bytes(path("generic/eight/case.json"))).at("wrong");
  wrong[0]["kind"] = "wrong time";
  change_case("generic/eight", "wrong", wrong);
  const std::string file = page({"--memory", "1073741824"});  // as sanitizers bear it
  const Json found = shown(file), report = data(file);
  expect_cases(found, report);
  for (const char* part : {"command", "legend", "families"}) EXPECT_EQ(found[part], Json()) << part;
  EXPECT_EQ(found["title"], "Degenerate cases");
  EXPECT_EQ(found["subtitle"],
            "The corpus held against itself by " + report["producer"].get<std::string>());
  EXPECT_EQ(found["passed"], "5");
  EXPECT_EQ(found["cases"], "of 6 cases as expected");
  EXPECT_EQ(found["bar"], Json::parse(R"([["certified",83],["refuted",17]])"));
  EXPECT_NE(
      found["meaning"].get<std::string>().find("Limits for each process: 60 s, 1073741824 MB."),
      std::string::npos);
  const Json right = result_named(found, "three");
  EXPECT_EQ(right["verdict"], "as expected");
  EXPECT_EQ(right["style"], "certified");
  EXPECT_EQ(right["reason"], "");
  const Json other = result_named(found, "eight");
  EXPECT_EQ(other["verdict"], "not so");
  EXPECT_EQ(other["style"], "refuted");
  EXPECT_EQ(other["reason"],
            "wrong/dropped-flip.history.jsonl: expected refuted (exact): wrong time, found refuted "
            "(exact): missing event");
  EXPECT_EQ(other["sources"], Json::array({"by hand"}));
  const Json& checks = report["results"][0]["checks"];
  ASSERT_EQ(other["rows"].size(), checks.size());
  double all = 0;
  for (std::size_t k = 0; k < checks.size(); ++k) {
    const Json& c = checks[k];
    all += c["seconds"].get<double>();
    EXPECT_EQ(other["rows"][k], Json::array({c["file"], c["expected"], c["found"], c["reason"],
                                             seconds(c["seconds"])}));
  }
  EXPECT_EQ(other["seconds"], seconds(all) + " s");
}

TEST_F(CorpusPageShown, TheButtonHidesTheCasesThatPassed) {
  const Json found = run_in_page(page({"--against", moody()}), R"js(
    const seen = () => Array.from(document.querySelectorAll("details"))
      .filter((details) => details.getClientRects().length > 0).length;
    const button = document.querySelector("button"), counts = [seen()];
    for (let k = 0; k < 2; ++k) { button.click(); counts.push(seen()); }
    return counts;)js");
  EXPECT_EQ(found.at("errors"), Json::array());
  EXPECT_EQ(found.at("result"), Json::array({6, 2, 6}));
}

// Tables that are wider scroll by themselves.
TEST_F(CorpusPageShown, FitsANarrowWindow) {
  for (const Arguments& more : {Arguments{"--against", moody()}, Arguments{}}) {
    const Json found = run_in_page(page(more), R"js(
      for (const details of document.querySelectorAll("details")) details.open = true;
      const { scrollWidth, clientWidth } = document.documentElement;
      return [scrollWidth, clientWidth];)js",
                                   "", "390,800");
    EXPECT_EQ(found.at("errors"), Json::array());
    EXPECT_EQ(found.at("result")[0], found.at("result")[1]);
    EXPECT_LE(found.at("result")[1], 500);
  }
}

TEST_F(CorpusPageShown, TextsAreNoElements) {
  add_hostile();
  const std::string command =
      "echo '" + std::string("</script><b><img src=x onerror=hurt=1>") + "' >&2; " + simulate();
  for (const Arguments& more : {Arguments{"--against", command}, Arguments{}}) {
    const Json found = shown(page(more));
    const Json result = result_named(found, hostile_name);
    EXPECT_FALSE(found["hurt"].get<bool>());
    EXPECT_EQ(found["images"], 6);
    EXPECT_EQ(found["sections"][0], hostile_name);
    EXPECT_EQ(result["story"], hostile);
    EXPECT_EQ(result["tags"], Json::array({hostile}));
    EXPECT_EQ(result["alt"], hostile_name + "/" + hostile_name);
    if (more.empty()) {
      EXPECT_EQ(result["sources"], Json::array({hostile}));
    } else {
      EXPECT_EQ(found["command"], command);
      EXPECT_EQ(result["paragraphs"],
                Json::array({"Last line on stderr: </script><b><img src=x onerror=hurt=1>"}));
    }
  }
}

}  // namespace
}  // namespace voroproof::internal
