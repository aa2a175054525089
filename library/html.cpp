#include "library/html.h"

#include <openssl/evp.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace voroproof::internal {
namespace {

std::string joined(std::span<const std::string_view> pieces) {
  std::string text;
  for (const std::string_view piece : pieces) text += piece;
  return text;
}

// The text as the content of an element.
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
      default:
        out += c;
    }
  }
  return out;
}

}  // namespace

std::string page_begin(const PageTemplate& page, std::string_view title) {
  return joined(page.before_title) + html_text(title) + joined(page.before_data);
}

std::string page_end(const PageTemplate& page) { return joined(page.after_data); }

std::string json_element(std::string_view id, const nlohmann::ordered_json& data) {
  std::string out = "<script type=\"application/json\" id=\"" + std::string(id) + "\">";
  // File names and messages need not be UTF-8.
  for (const char c : data.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace)) {
    if (c == '<') {
      out += "\\u003c";
    } else {
      out += c;
    }
  }
  return out + "</script>\n";
}

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

}  // namespace voroproof::internal
