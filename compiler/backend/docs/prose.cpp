#include "compiler/backend/docs/prose.h"

#include <fmt/format.h>

#include <cctype>
#include <string_view>
#include <vector>

#include "compiler/backend/draw/style.h"

namespace jrule::docs {

namespace {

using draw::escape;

bool is_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

std::string linked(std::string_view text, std::string const& shown, Links const& links) {
  auto const link = links.find(text);
  return link == links.end() ? shown : fmt::format("<a href=\"{}\">{}</a>", escape(link->second), shown);
}

/// Names among other text.
std::string words(std::string_view text, Links const& links) {
  std::string html;
  while (!text.empty()) {
    std::size_t length = 0;
    bool const name = is_name(text[0]);
    while (length < text.size() && is_name(text[length]) == name) ++length;
    std::string_view const word = text.substr(0, length);
    html += name && word.find('_') != std::string_view::npos ? linked(word, escape(word), links) : escape(word);
    text.remove_prefix(length);
  }
  return html;
}

}  // namespace

std::string inline_prose(std::string const& text, Links const& links) {
  std::string html;
  std::size_t at = 0;
  while (at < text.size()) {
    std::size_t const open = text.find('`', at), close = open == std::string::npos ? open : text.find('`', open + 1);
    if (close == std::string::npos) break;  // one without its other half stands for itself
    html += words(std::string_view(text).substr(at, open - at), links);
    std::string const code = text.substr(open + 1, close - open - 1);
    html += linked(code, fmt::format("<code>{}</code>", escape(code)), links);
    at = close + 1;
  }
  return html + words(std::string_view(text).substr(at), links);
}

std::string prose(std::string const& doc, Links const& links) {
  std::string html, paragraph;
  std::vector<std::string> items;
  auto const flush = [&] {
    if (!paragraph.empty()) html += "<p>" + inline_prose(paragraph, links) + "</p>\n";
    if (!items.empty()) {
      html += "<ul>\n";
      for (std::string const& item : items) html += "<li>" + inline_prose(item, links) + "</li>\n";
      html += "</ul>\n";
    }
    paragraph.clear();
    items.clear();
  };
  std::size_t begin = 0;
  while (begin < doc.size()) {
    std::size_t const end = std::min(doc.find('\n', begin), doc.size());
    std::string const line = doc.substr(begin, end - begin);
    begin = end + 1;
    if (line.find_first_not_of(' ') == std::string::npos) {
      flush();
    } else if (line.starts_with("- ")) {
      if (items.empty()) flush();
      items.push_back(line.substr(2));
    } else {
      std::string& text = items.empty() ? paragraph : items.back();
      if (!text.empty()) text += '\n';
      text += line;
    }
  }
  flush();
  return html;
}

std::string first_sentence(std::string const& doc) {
  std::string text = doc.substr(0, doc.find("\n\n"));
  for (std::size_t at = text.find('.'); at != std::string::npos; at = text.find('.', at + 1)) {
    if (at + 1 == text.size() || text[at + 1] == ' ' || text[at + 1] == '\n') return text.substr(0, at + 1);
  }
  return text;
}

}  // namespace jrule::docs
