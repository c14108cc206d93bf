// A modeler of Jerboa, as its editor saves it in a .jme file: what is written there and where, and nothing decided yet.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "compiler/source/source.h"

namespace jrule::jerboa {

using source::Span;

struct Name {
  std::string text;
  Span span;
};

/// Java, C++, or the language of Jerboa's scripts; or a comment.
struct Snippet {
  std::string text;                    ///< without the entities of XML
  source::FileId file = source::no_file;
  std::vector<std::uint32_t> offsets;  ///< where each byte of the text begins in the file, and where the last one ends

  bool blank() const { return text.find_first_not_of(" \t\r\n\f\v") == std::string::npos; }
  /// The place in the file of the bytes [begin, end) of the text.
  Span place(std::size_t begin, std::size_t end) const;
  /// All of it, but for blanks around it.
  Span place() const;
};

inline constexpr int removed = -1;
/// Dimensions, and in decorations of nodes `removed`.
using Orbit = std::vector<int>;

struct Embedding {
  Name name;
  Name type;
  Orbit orbit;
  Snippet comment;
  Snippet default_code;
};

/// The value that a right node gives to an embedding.
struct Clause {
  Name embedding;
  Snippet code;
};
struct Node {
  Name name;
  Orbit orbit;
  bool hook = false;
  Name multiplicity;  ///< how many darts a hook takes: `{1}`; empty if not said
  std::vector<Clause> clauses;
  Snippet precondition;
};
/// With its reverse; a loop if both nodes are one.
struct Arc {
  int dimension = 0;
  std::string a, b;
  Span span;
};
struct Side {
  std::vector<Node> nodes;
  std::vector<Arc> arcs;
};

struct Parameter {
  Name name;
  Name type;
  Snippet default_code;
};
struct Rule {
  Name name;
  Snippet comment, header, precondition, preprocess, midprocess, postprocess;
  Side left, right;
  std::vector<Parameter> parameters;  ///< in their order
  std::vector<std::string> hooks;     ///< the nodes that an application gives darts for, in their order
};
/// A program that calls rules.
struct Script {
  Name name;
  Snippet content;
};

struct Modeler {
  Name name;
  int dimension = 0;
  Snippet comment, header;
  std::vector<Embedding> embeddings;
  std::vector<Rule> rules;
  std::vector<Script> scripts;
};

}  // namespace jrule::jerboa
