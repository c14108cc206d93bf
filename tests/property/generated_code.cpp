#include "tests/property/generated_code.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <cctype>
#include <filesystem>
#include <map>
#include <sstream>
#include <stdexcept>

#include "compiler/analysis/independence.h"
#include "compiler/backend/cpp/emit.h"
#include "tests/process/process.h"

namespace jrule::property {

namespace {

using Copies = std::vector<std::vector<Dart>>;

/// What a loaded library holds for each rule.
struct Entry {
  Result<Copies> (*apply)(Map& map, std::vector<Dart> const& hooks);
  Result<void> (*everywhere)(Map& map, Threads threads);
};

char const preamble[] = R"(
using Copies = std::vector<std::vector<jrule::Dart>>;

struct Entry {
  jrule::Result<Copies> (*apply)(jrule::Map& map, std::vector<jrule::Dart> const& hooks);
  jrule::Result<void> (*everywhere)(jrule::Map& map, jrule::Threads threads);
};

namespace {

[[maybe_unused]] std::vector<jrule::Dart> list(std::span<jrule::Dart const> darts) { return {darts.begin(), darts.end()}; }

// Generated functions work on a modeler that owns its map.
template <class Modeler, class Apply>
auto on_modeler(jrule::Map& map, Apply apply) -> decltype(apply(std::declval<Modeler&>())) {
  auto modeler = Modeler::from_map(map);
  if (!modeler) return tl::unexpected(modeler.error());
  auto result = apply(*modeler);
  map = std::move(modeler->map());
  return result;
}
)";

/// The name of the generated class of a modeler that no module declares: "Gmap" for "gmap".
std::string class_name(std::string const& modeler) {
  std::string name;
  for (char const c : modeler) {
    bool const start = name.empty() || name.back() == '_';
    if (!name.empty() && start) name.pop_back();
    name += start ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
  }
  return name;
}

bool is_independent(AcceptedRule const& rule) {
  return analysis::analyze_independence(rule.scheme, rule.plan).independent();
}

/// The functions of one rule as an Entry: `{[](…) {…}, [](…) {…}},`.
std::string entry(AcceptedRule const& accepted, std::string const& name_space) {
  ir::RuleScheme const& rule = accepted.scheme;
  std::string const modeler = name_space + "::" + class_name(rule.modeler->name),
                    function = name_space + "::" + rule.name;
  std::string hooks, copies;
  for (std::size_t h = 0; h < rule.hooks.size(); ++h) hooks += fmt::format(", hooks[{}]", h);
  for (ir::Node const& node : rule.nodes) {
    std::string const copy = node.deleted()       ? "{}"
                             : rule.hooks.empty() ? "{result->" + node.name + "}"
                                                  : fmt::format("list(result->copies.{})", node.name);
    copies += (copies.empty() ? "" : ", ") + copy;
  }
  std::string const apply = fmt::format(
      R"([](jrule::Map& map, [[maybe_unused]] std::vector<jrule::Dart> const& hooks) {{
       return on_modeler<{}>(map, [&](auto& modeler) -> jrule::Result<Copies> {{
         auto const result = {}(modeler{});
         if (!result) return tl::unexpected(result.error());
         return Copies{{{}}};
       }});
     }})",
      modeler, function, hooks, copies);
  std::string const everywhere = fmt::format(
      R"([](jrule::Map& map, [[maybe_unused]] jrule::Threads threads) {{
       return on_modeler<{}>(map, [&](auto& modeler) {{ return {}_everywhere(modeler{}); }});
     }})",
      modeler, function, is_independent(accepted) ? ", threads" : "");
  return fmt::format("    {{{},\n     {}}},\n", apply, rule.hooks.size() == 1 ? everywhere : "nullptr");
}

/// Prints one module for each model into the folder, and a source that includes them all and holds the table.
void print_code(std::vector<AcceptedRule> const& rules, std::string const& name, std::filesystem::path const& folder) {
  std::map<std::string, std::vector<cpp::Rule>> modules;
  std::string entries;
  for (AcceptedRule const& rule : rules) {
    Model const& model = rule.scheme.model();
    // Also the namespace: other libraries of this program must not define the same functions.
    std::string const module = name + '_' + model.name + '_' + std::to_string(model.dimension);
    entries += entry(rule, module);
    modules[module].push_back({&rule.scheme, &rule.plan});
  }
  source::Sources sources;
  sources.add("random.jrule", "");  // where random rules say that they are written
  std::string text;
  for (auto const& [module, members] : modules) {
    source::Diagnostics diagnostics;
    auto const files = cpp::emit({module, {}, {}}, members, sources, {}, diagnostics);
    for (source::Diagnostic const& d : diagnostics.all()) throw std::runtime_error("emit: " + d.message);
    for (cpp::GeneratedFile const& file : files) tests::write(folder / file.name, file.text);
    text += "#include \"" + module + ".cpp\"\n";
  }
  text += preamble;
  text += "\n}  // namespace\n\nextern \"C\" {\nextern Entry const jrule_rules[];\nEntry const jrule_rules[] = {\n" +
          entries + "};\n}\n";
  tests::write(folder / "rules.cpp", text);
}

/// The command line, up to what is compiled, that the build wrote down: a word a line.
std::vector<std::string> compiler_words() {
  std::istringstream lines(tests::read(JRULE_COMPILER_WORDS));
  std::vector<std::string> words;
  for (std::string line; std::getline(lines, line);) {
    if (!line.empty()) words.push_back(line);
  }
  return words;
}

void run_compiler(std::filesystem::path const& folder, std::vector<std::string> const& further) {
  std::vector<std::string> words = compiler_words();
  words.insert(words.end(), further.begin(), further.end());
  tests::Outcome const outcome = tests::run(folder, words);
  if (outcome.exit_status != 0)
    throw std::runtime_error("generated code in " + folder.string() + " does not compile:\n" + outcome.output);
}

}  // namespace

std::filesystem::path make_folder(std::string const& name) {
  std::filesystem::path const folder = std::filesystem::path(JRULE_GENERATED_CODE) / name;
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder;
}

void* load(std::filesystem::path const& folder, std::string const& file, char const* symbol) {
  run_compiler(folder, {"-c", file, "-o", "rules.o"});
  run_compiler(folder, {"-shared", "rules.o", "-o", "rules.so"});
  // Never closed: the functions stay.
  void* const library = dlopen((folder / "rules.so").c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) throw std::runtime_error(dlerror());
  void* const found = dlsym(library, symbol);
  if (found == nullptr) throw std::runtime_error(dlerror());
  return found;
}

std::vector<GeneratedRule> compile_rules(std::vector<AcceptedRule> const& rules, std::string const& name) {
  std::filesystem::path const folder = make_folder(name);
  print_code(rules, name, folder);
  auto const* const entries = static_cast<Entry const*>(load(folder, "rules.cpp", "jrule_rules"));
  std::vector<GeneratedRule> generated;
  for (std::size_t i = 0; i < rules.size(); ++i) {
    Entry const& e = entries[i];
    generated.push_back({[apply = e.apply](Map& map, std::vector<Dart> const& hooks) -> Result<interpreter::Applied> {
                           auto copies = apply(map, hooks);
                           if (!copies) return tl::unexpected(copies.error());
                           return interpreter::Applied{std::move(*copies), 0};
                         },
                         e.everywhere});
  }
  return generated;
}

}  // namespace jrule::property
