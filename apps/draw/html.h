// The parts of a page that needs no other file: frame and style, text, pictures.
#pragma once

#include <string>
#include <string_view>

namespace voroproof::internal {

// Bytes as text that HTML and JSON can hold (RFC 4648, with padding, without line breaks).
std::string base64(std::string_view bytes);

// The whole page around its body.
std::string html_page(const std::string& title, const std::string& body);

// The text with what HTML gives a meaning escaped, fit for content and for quoted attributes.
std::string html_text(std::string_view text);

// An <img> of the SVG file; empty where there is no such file.
std::string html_picture(const std::string& path, const std::string& description);

}  // namespace voroproof::internal
