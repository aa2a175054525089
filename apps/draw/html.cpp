#include "apps/draw/html.h"

#include <openssl/evp.h>

#include <algorithm>
#include <filesystem>

#include "history/file_bytes.h"

namespace voroproof::internal {
namespace {

constexpr std::size_t max_picture_bytes = std::size_t{1} << 24;

constexpr std::string_view style = R"css(
:root {
  --paper: #fcfcfa; --card: #ffffff; --ink: #1d2329; --faint: #66707a; --line: #dfe3e6;
  --certified: #2e7d4f; --refuted: #b3372f; --undecided: #a86f00; --invalid: #7b4397;
  --crashed: #4a5561; --timed-out: #2f6690;
}
@media (prefers-color-scheme: dark) {
  :root {
    --paper: #15181b; --card: #1d2126; --ink: #e4e7ea; --faint: #98a2ac; --line: #343b42;
    --certified: #4fae78; --refuted: #e0675d; --undecided: #d9a035; --invalid: #b07fc9;
    --crashed: #8a96a3; --timed-out: #5c9bc9;
  }
}
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 2rem 1.5rem 4rem; max-width: 80rem; background: var(--paper);
  color: var(--ink); font: 15px/1.5 system-ui, "Segoe UI", "DejaVu Sans", sans-serif; }
h1 { font-size: 1.6rem; margin: 0 0 .3rem; }
h2 { font-size: 1.1rem; margin: 2.2rem 0 .6rem; }
code, .mono { font: 13px/1.5 ui-monospace, "DejaVu Sans Mono", monospace; }
code { overflow-wrap: anywhere; }
.faint { color: var(--faint); }
.command { display: block; padding: .6rem .8rem; margin: .8rem 0; background: var(--card);
  border: 1px solid var(--line); border-radius: 6px; }
.score { display: flex; align-items: baseline; gap: .6rem; margin: 1.2rem 0 .5rem; }
.score b { font-size: 2.2rem; line-height: 1; }
.bar { display: flex; height: .6rem; border-radius: 3px; overflow: hidden; background: var(--line); }
.bar i { display: block; height: 100%; }
.legend { display: flex; flex-wrap: wrap; gap: .3rem 1.2rem; margin: .6rem 0; color: var(--faint); }
.legend i { display: inline-block; width: .7rem; height: .7rem; border-radius: 2px;
  margin-right: .35rem; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; width: 100%; background: var(--card);
  border: 1px solid var(--line); border-radius: 6px; }
th, td { padding: .35rem .7rem; text-align: left; border-top: 1px solid var(--line);
  vertical-align: middle; }
thead th { border-top: 0; color: var(--faint); font-weight: 600; font-size: .85rem;
  white-space: nowrap; }
td.n, th.n { text-align: right; font-variant-numeric: tabular-nums; }
td.zero { color: var(--line); }
td.share { min-width: 6rem; }
.kind { display: block; white-space: nowrap; }
td.word { white-space: nowrap; overflow-wrap: normal; }
tr.all td { font-weight: 600; border-top: 2px solid var(--line); }
.certified { color: var(--certified); } .refuted { color: var(--refuted); }
.undecided { color: var(--undecided); } .invalid { color: var(--invalid); }
.crashed { color: var(--crashed); } .timed-out { color: var(--timed-out); }
i.certified { background: var(--certified); } i.refuted { background: var(--refuted); }
i.undecided { background: var(--undecided); } i.invalid { background: var(--invalid); }
i.crashed { background: var(--crashed); } i.timed-out { background: var(--timed-out); }
details { background: var(--card); border: 1px solid var(--line); border-top: 0; }
h2 + details { border-top: 1px solid var(--line); border-radius: 6px 6px 0 0; }
details:last-of-type { border-radius: 0 0 6px 6px; }
summary { display: grid; grid-template-columns: 7.5rem minmax(10rem, 20rem) 1fr 5rem; gap: .8rem;
  align-items: baseline; padding: .4rem .8rem; cursor: pointer; list-style: none; }
summary::-webkit-details-marker { display: none; }
summary:hover { background: color-mix(in srgb, var(--line) 35%, transparent); }
summary b { font-weight: 600; }
summary b::before { content: "\25b8"; margin-right: .5rem; color: var(--faint); }
details[open] summary b::before { content: "\25be"; }
summary .reason { color: var(--faint); overflow: hidden; text-overflow: ellipsis;
  white-space: nowrap; }
summary .n { text-align: right; color: var(--faint); font-variant-numeric: tabular-nums; }
details[open] summary { border-bottom: 1px solid var(--line); }
details[open] summary .reason { visibility: hidden; }
.case { display: grid; grid-template-columns: 17rem 1fr; gap: 1.4rem; padding: 1rem .8rem; }
.case > * { min-width: 0; }
.case ul { margin: 0 0 .8rem; padding-left: 1.2rem; }
.case.bare { grid-template-columns: 1fr; }
.case img { width: 100%; background: #fff; border: 1px solid var(--line); border-radius: 4px; }
.case p { margin: 0 0 .7rem; max-width: 46rem; }
.case table { margin: .4rem 0 .8rem; }
.case td { vertical-align: top; overflow-wrap: anywhere; }
.tag { display: inline-block; padding: 0 .5rem; margin: 0 .3rem .3rem 0; border-radius: 1rem;
  border: 1px solid var(--line); color: var(--faint); font-size: .8rem; }
.buttons { margin: 1.6rem 0 -.8rem; }
button { font: inherit; font-size: .85rem; color: var(--ink); background: var(--card);
  border: 1px solid var(--line); border-radius: 4px; padding: .25rem .7rem; cursor: pointer; }
body.failed details.passed { display: none; }
@media (max-width: 50rem) {
  summary { grid-template-columns: 6rem 1fr 4rem; }
  summary .reason { display: none; }
  .case { grid-template-columns: 1fr; }
}
)css";

}  // namespace

std::string base64(std::string_view bytes) {
  // A multiple of three, so that only the last piece is padded; libcrypto counts in ints.
  constexpr std::size_t piece = 3 << 20;
  std::string text((bytes.size() + 2) / 3 * 4 + 1, '\0');  // libcrypto ends each piece with a 0
  std::size_t length = 0;
  for (std::size_t k = 0; k < bytes.size(); k += piece) {
    length += EVP_EncodeBlock(reinterpret_cast<unsigned char*>(&text[length]),
                              reinterpret_cast<const unsigned char*>(&bytes[k]),
                              static_cast<int>(std::min(piece, bytes.size() - k)));
  }
  text.resize(length);
  return text;
}

std::string html_page(const std::string& title, const std::string& body) {
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
         html_text(title) + "</title>\n<style>" + std::string(style) +
         "</style>\n</head>\n<body>\n" + body + "</body>\n</html>\n";
}

std::string html_text(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

std::string html_picture(const std::string& path, const std::string& description) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return {};
  return "<img loading=\"lazy\" alt=\"" + html_text(description) +
         "\" src=\"data:image/svg+xml;base64," + base64(file_bytes(path, max_picture_bytes)) +
         "\">";
}

}  // namespace voroproof::internal
