// Pages that need no other file: a template of the build, and data put into it.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>

namespace voroproof::internal {

// A page with a gap for its title and one for its data, each part in pieces.
// packaging/cmake/EmbedPage.cmake makes it of a folder's page.html.
struct PageTemplate {
  std::span<const std::string_view> before_title, before_data, after_data;
};

// The page up to its data, and what comes after them.
std::string page_begin(const PageTemplate& page, std::string_view title);
std::string page_end(const PageTemplate& page);

// An element with JSON for the page's scripts. No text in it can end the element.
std::string json_element(std::string_view id, const nlohmann::ordered_json& data);

// Bytes as text that HTML and JSON can hold (RFC 4648, with padding, without line breaks).
std::string base64(std::string_view bytes);

}  // namespace voroproof::internal
