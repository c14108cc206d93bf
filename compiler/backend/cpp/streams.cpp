#include "compiler/backend/cpp/streams.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>

#include "compiler/backend/cpp/text.h"

namespace jrule::cpp {

using Kind = analysis::OrbitComponent::Kind;

namespace {

// Do all arcs of the component's orbits lie on the right side? Then the orbits are its members, and reach nothing else.
bool is_closed(Function const& f, analysis::OrbitComponent const& component) {
  ir::Table const table(f.rule.nodes.size(), f.rule.right);
  for (auto const& member : component.members) {
    for (Word const& word : f.spec(component.embedding).orbit.words) {
      ir::NodeId at = member.node;
      for (Letter const letter : word) {
        ir::Arc const* const arc = letter.conjugate ? table.in(at, letter.dimension) : table.out(at, letter.dimension);
        if (arc == nullptr) return false;
        at = letter.conjugate ? arc->source : arc->target;
      }
    }
  }
  return true;
}

}  // namespace

bool is_walked(Function const& f, analysis::OrbitComponent const& component) {
  return component.kind == Kind::merge || (component.kind == Kind::assign && !is_closed(f, component));
}

std::string arc_comment(Function const& f, ir::Arc const& arc) {
  return fmt::format("{}: {}", place(f.sources, arc.span), arc_text(f.rule, arc.source, arc.dimension, arc.word, arc.target));
}

namespace {

// A loop that writes columns of the map: what each index writes, no other one writes too.
struct Stream {
  std::string comment;
  std::vector<std::string> statements;  // in the loop; or each a call for all indices
  bool are_calls = false;
  // Columns of the map that it reads, and those that it writes elsewhere than at its index, where others read.
  std::vector<std::string> reads{}, scatters{};
};

// Streams that follow each other on one thread, a part of the indices at a time, where none writes what another one reads at other
// indices.
bool go_together(Stream const& a, Stream const& b) {
  auto const meet = [](std::vector<std::string> const& scattered, std::vector<std::string> const& read) {
    return std::find_first_of(scattered.begin(), scattered.end(), read.begin(), read.end()) != scattered.end();
  };
  return !meet(a.scatters, b.reads) && !meet(b.scatters, a.reads);
}

void write_stream(Writer& out, Function const& f, Stream const& stream) {
  if (!stream.comment.empty()) out.line("// {}", stream.comment);
  if (stream.are_calls) {
    for (std::string const& statement : stream.statements) out.text(statement);
    return;
  }
  if (stream.statements.size() == 1) return out.line("{} {}", f.stream(), stream.statements[0]);
  out.open("{} {{", f.stream());
  for (std::string const& statement : stream.statements) out.text(statement);
  out.close();
}

void write_all(Writer& out, Function const& f, std::vector<Stream> const& streams) {
  if (!f.takes_threads()) {
    for (Stream const& stream : streams) write_stream(out, f, stream);
    return;
  }
  for (auto next = streams.begin(); next != streams.end();) {
    auto const first = next;
    out.open("jrule::parallel::for_streams({}, {}, [&](std::size_t {}, std::size_t {}) {{", f.size, f.threads, f.local("begin"), f.local("end"));
    do {
      write_stream(out, f, *next++);
    } while (next != streams.end() && std::all_of(first, next, [&](Stream const& before) { return go_together(before, *next); }));
    out.close("});");
  }
}

// The map's own column that the word's is, if it is.
std::vector<std::string> read_columns(Function const& f, Word const& word) {
  if (!f.is_aliased(word)) return {};
  Letter const letter = word.front();
  auto const d = static_cast<std::size_t>(letter.dimension);
  return {letter.conjugate && f.rule.model().is_oriented(letter.dimension) ? f.arc_sources[d] : f.arcs[d]};
}

// "begin, end".
std::string range(Function const& f) { return f.takes_threads() ? f.local("begin") + ", " + f.local("end") : "0, " + f.size; }

// If dense: the column of a node's copies in one of the map's, "arcs_0 + added_b".
std::string part(Function const& f, std::string const& column, ir::NodeId id) {
  return f.node(id).added() ? fmt::format("{} + {}", column, f.darts[id]) : column;
}

// If dense: what writes the copies of `to` at the word into that column.
std::string stream_call(Function const& f, std::string const& column, ir::NodeId to, Word const& word) {
  std::string const first = f.node(to).added() ? f.darts[to] : "0";
  return word.empty() ? fmt::format("jrule::stream::count_up({}, {}, {});", column, range(f), first)
                      : fmt::format("jrule::stream::shift({}, {}, {}, {});", column, f.columns.at(word), range(f), first);
}

Stream arc_stream(Function const& f, ir::Arc const& arc) {
  auto const d = static_cast<std::size_t>(arc.dimension);
  Stream stream{arc_comment(f, arc), {}, false, read_columns(f, arc.word)};
  bool const oriented = f.rule.model().is_oriented(arc.dimension);
  if (f.form == Form::dense && (!oriented || arc.word.empty())) {
    stream.are_calls = true;
    stream.statements = {stream_call(f, part(f, f.arcs[d], arc.source), arc.target, arc.word)};
    if (oriented) stream.statements.push_back(stream_call(f, part(f, f.arc_sources[d], arc.target), arc.source, {}));
  } else if (!oriented) {
    stream.statements = {fmt::format("{}[{}] = {};", f.arcs[d], f.place(arc.source), f.written(arc.target, arc.word))};
  } else {
    stream.statements = {
        fmt::format("std::size_t const {} = {}, {} = {};", f.local("at"), f.place(arc.source), f.local("to"), f.place(arc.target, arc.word)),
        fmt::format("{}[{}] = static_cast<jrule::Dart>({});", f.arcs[d], f.local("at"), f.local("to")),
        fmt::format("{}[{}] = static_cast<jrule::Dart>({});", f.arc_sources[d], f.local("to"), f.local("at"))};
  }
  if (f.form == Form::dense && f.rule.model().is_oriented(arc.dimension) && !f.node(arc.target).added() && !arc.word.empty()) {
    stream.scatters = {f.arc_sources[d]};
  }
  return stream;
}

// The handles of a component's darts that need no walk.
std::vector<Stream> handle_streams(Function const& f, std::size_t c) {
  auto const& component = f.plan.orbits[c];
  std::string const& handles = f.dart_handles[component.embedding];
  std::vector<Stream> streams;
  if (component.kind == Kind::inherit) {
    for (std::size_t i = 0; i < component.sources.size(); ++i) {
      auto const& source = component.sources[i];
      // Matched darts still have their handles; where a walk led from them, it led before the arcs changed.
      bool const is_known = !source.tail.empty();
      std::string const value = is_known ? fmt::format("{}[{}]", f.inherited[c][i], f.index)
                                         : fmt::format("{}[{}]", handles, f.place(source.preserved, source.word));
      Stream stream{"", {fmt::format("{}[{}] = {};", handles, f.place(source.added), value)}};
      if (f.form == Form::dense && (is_known || source.word.empty())) {
        stream.are_calls = true;
        stream.statements = {fmt::format("jrule::stream::shift({}, {}, {}, 0);", part(f, handles, source.added),
                                         is_known ? f.inherited[c][i] : handles, range(f))};
      }
      if (!is_known) {
        stream.reads = read_columns(f, source.word);
        stream.reads.push_back(handles);
      }
      streams.push_back(std::move(stream));
    }
    return streams;
  }
  std::string const handle =
      component.kind == Kind::fresh && !component.clause ? f.handles[c] : fmt::format("{}[{}]", f.handles[c], f.index);
  for (auto const& member : component.members) {
    Stream stream{"", {fmt::format("{}[{}] = {};", handles, f.place(member.node, member.path), handle)}, false, read_columns(f, member.path)};
    if (f.form == Form::dense && component.clause && member.path.empty()) {
      stream.are_calls = true;
      stream.statements = {fmt::format("jrule::stream::shift({}, {}, {}, 0);", part(f, handles, member.node), f.handles[c], range(f))};
    }
    if (!f.node(member.node).added()) stream.scatters = {handles};
    streams.push_back(std::move(stream));
  }
  return streams;
}

// Orbits whose darts are known: they are written in columns.
std::vector<Stream> known_handles(Function const& f) {
  std::vector<Stream> streams;
  std::optional<std::size_t> last;
  for (std::size_t c = 0; c < f.plan.orbits.size(); ++c) {
    auto const& component = f.plan.orbits[c];
    if (is_walked(f, component)) continue;
    std::vector<Stream> further = handle_streams(f, c);
    if (last != component.embedding && !further.empty()) further.front().comment = f.spec(component.embedding).name;
    last = component.embedding;
    streams.insert(streams.end(), std::make_move_iterator(further.begin()), std::make_move_iterator(further.end()));
  }
  return streams;
}

// Darts that no handle is written to: their embedding is walked.
std::vector<Stream> missing_handles(Function const& f) {
  std::vector<Stream> streams;
  for (std::size_t e = 0; e < f.embeddings.size(); ++e) {
    std::vector<ir::NodeId> missing = f.plan.added;
    for (auto const& component : f.plan.orbits) {
      if (component.embedding != e) continue;
      std::erase_if(missing, [&](ir::NodeId id) {
        if (component.kind != Kind::inherit && !is_walked(f, component)) {
          return std::any_of(component.members.begin(), component.members.end(), [&](auto const& m) { return m.node == id; });
        }
        return component.kind == Kind::inherit &&
               std::any_of(component.sources.begin(), component.sources.end(), [&](auto const& s) { return s.added == id; });
      });
    }
    for (ir::NodeId const id : missing) {
      streams.push_back({"", {fmt::format("{}.embedding({}).handles_of_darts()[{}] = jrule::no_handle;", f.map, e, f.place(id))}});
    }
  }
  return streams;
}

// Arcs and handles that are written in columns.
std::vector<Stream> streams(Function const& f) {
  std::vector<Stream> arcs, handles = known_handles(f);
  if (!f.merges_on_trial()) {
    for (ir::Arc const* arc : f.writes) arcs.push_back(arc_stream(f, *arc));
  }
  if (f.form != Form::dense) {
    arcs.insert(arcs.end(), handles.begin(), handles.end());
    return arcs;
  }
  // Before the arcs: columns that are the map's own are still what they were.
  std::vector<Stream> all = missing_handles(f);
  all.insert(all.end(), handles.begin(), handles.end());
  all.insert(all.end(), arcs.begin(), arcs.end());
  return all;
}

}  // namespace

void write_streams(Writer& out, Function const& f) { write_all(out, f, streams(f)); }

}  // namespace jrule::cpp
