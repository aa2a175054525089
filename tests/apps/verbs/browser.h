// A page opened by a browser that is not seen, as far as Debian's chromium is installed.
#pragma once

#include <cstdlib>
#include <string>

#include "tests/apps/verbs/cli.h"

namespace voroproof::internal {

// A base of fixtures beside Cli.
class Browser {
 protected:
  // Skips the test where there is no browser; for SetUp.
  static void require_browser() {
    if (std::system("command -v chromium >/dev/null 2>&1") != 0) {
      GTEST_SKIP() << "chromium is not installed: scripts/install-deps.sh browser";
    }
  }

  // Opens the page at a place ("#t=1", or empty) in a window of so many pixels and returns what
  // `script`, the body of a function that runs when the page has been set up, returns. `errors`
  // of the result are what went wrong in the page.
  Json run_in_page(const std::string& page, const std::string& script,
                   const std::string& place = "", const std::string& window = "1000,700") {
    std::string html = read_bytes(page);
    const std::string watch =
        "<script>window.errors = []; window.addEventListener('error', "
        "(event) => window.errors.push(event.message));</script>\n";
    const std::string probe =
        "<script>{ let result; try { result = (() => {" + script +
        "\n})(); } catch (error) { window.errors.push(String(error)); }\n"
        "const text = JSON.stringify({ result, errors: window.errors });\n"
        "document.body.textContent = 'BEGIN' + btoa(text) + 'END'; }</script>\n";
    html.insert(html.find("<body>"), watch);
    html.insert(html.find("</body>"), probe);
    // Everything anew each time: a browser that is still about to end must not answer for the next.
    const std::string run = std::to_string(runs_++);
    const std::string probed = scratch_.write("probed" + run + ".html", html);
    // Browsers refuse to run as root, as containers do, with their sandbox on.
    const std::string command =
        "timeout 120 chromium --headless --no-sandbox --disable-gpu --disable-dev-shm-usage "
        "--user-data-dir=" +
        scratch_.file("profile" + run) + " --window-size=" + window + " --dump-dom 'file://" +
        probed + place + "' >" + scratch_.file("dom" + run) + " 2>/dev/null";
    EXPECT_EQ(std::system(command.c_str()), 0) << command;
    const std::string dom = scratch_.read("dom" + run);
    const auto begin = dom.find("BEGIN"), end = dom.find("END", begin);
    if (begin == std::string::npos || end == std::string::npos) {
      ADD_FAILURE() << "the page said nothing: " << dom.substr(0, 500);
      return Json::object();
    }
    return Json::parse(from_base64(dom.substr(begin + 5, end - begin - 5)));
  }

 private:
  TemporaryDirectory scratch_;
  int runs_ = 0;

  static std::string from_base64(const std::string& text) {
    std::string bytes;
    unsigned group = 0, bits = 0;
    for (const char c : text) {
      static const std::string digits =
          "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
      const auto value = digits.find(c);
      if (value == std::string::npos) break;
      group = group << 6 | static_cast<unsigned>(value);
      bits += 6;
      if (bits < 8) continue;
      bits -= 8;
      bytes += static_cast<char>(group >> bits & 255);
    }
    return bytes;
  }
};

}  // namespace voroproof::internal
