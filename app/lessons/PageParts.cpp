#include "app/lessons/PageParts.h"

#include <algorithm>
#include <cstddef>

#include "app/lessons/LessonPageStyle.h"
#include "app/lessons/Markdown.h"

namespace umbra {
namespace {

std::string base64(std::string_view bytes) {
  constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    unsigned group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      text += k <= count ? digits[group >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

}  // namespace

std::string pageStart(const std::string& title, std::string_view style) {
  return "<!DOCTYPE html>\n<html lang=\"en-GB\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
         escapedHtml(title) + "</title>\n<style>" + lessonPageStyle + std::string(style) +
         "</style>\n</head>\n<body>\n";
}

std::string pictureInPage(std::string_view png, const std::string& caption) {
  const std::string text = escapedHtml(caption);
  return "<figure><img alt=\"" + text + "\" src=\"data:image/png;base64," + base64(png) +
         "\"><figcaption>" + text + "</figcaption></figure>\n";
}

}  // namespace umbra
