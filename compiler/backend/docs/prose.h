// Documentation comments as HTML.
#pragma once

#include <map>
#include <string>

namespace jrule::docs {

/// Where names lead: "insert_vertex" to "#insert_vertex".
using Links = std::map<std::string, std::string, std::less<>>;

/// Paragraphs, at empty lines; lists, of lines that begin with "- "; `code` between backticks, on one paragraph. Names of `links` that are
/// code, or that no word of English could be because they have a `_`, lead there. All else is text, whatever is in it. Well-formed XML.
std::string prose(std::string const& doc, Links const& links);
/// The same of one line of text, without paragraphs.
std::string inline_prose(std::string const& text, Links const& links);

/// The first sentence, as far as its full stop or the end of the paragraph.
std::string first_sentence(std::string const& doc);

}  // namespace jrule::docs
