// The subcommands of `jrule`, each in its own file: options in, exit status out. Only this folder prints.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace jrule::driver {

/// Exit statuses (language reference, section 9).
inline constexpr int exit_ok = 0;
inline constexpr int exit_refused = 1;   ///< errors in sources, a rule that is refused or not applicable, an invalid map
inline constexpr int exit_usage = 2;     ///< a wrong command line, a file that cannot be read or written
inline constexpr int exit_internal = 70; ///< a fault of the compiler

enum class MessageFormat { human, json };
enum class ColorMode { automatic, always, never };

/// What every command that reads rules takes.
struct Common {
  std::vector<std::string> import_dirs;  ///< -I
  MessageFormat format = MessageFormat::human;
  ColorMode color = ColorMode::automatic;
  bool warnings_are_errors = false;  ///< -W error
};

struct CheckOptions {
  Common common;
  std::vector<std::string> files;
  std::string counterexamples;  ///< the folder that counterexamples are written to; empty: none
};
int check(CheckOptions const& options);

struct EmitOptions {
  Common common;
  std::string stage;  ///< ast, ir, jrule, cpp, plugin, dot, svg, certificate
  std::vector<std::string> files;  ///< one, but of `plugin`; or FILE:RULE: that rule alone
  std::optional<int> dimension;  ///< the n of a rule on `gmap(n)`
  std::string directory;  ///< -o; empty: standard output
  std::string depfile;    ///< a make-style file of what was read; only with -o
  bool write_if_changed = false;
  std::string name_space, header_prefix;
  std::string name;  ///< of the plugin; empty: the first file's
};
int emit(EmitOptions const& options);
/// Its stage `plugin`.
int emit_plugin(EmitOptions const& options);

struct DocsOptions {
  Common common;
  std::vector<std::string> files;
  std::string directory;  ///< -o; empty: standard output, of one file
};
int docs(DocsOptions const& options);

/// What every command that changes a mesh takes.
struct ChangeOptions {
  std::string in, out;
  std::string at;                   ///< places on the mesh
  std::string picture;              ///< an SVG of the result; empty: none
  std::vector<std::string> values;  ///< NAME=VALUE
  bool stats_json = false;
};

struct ApplyOptions : ChangeOptions {
  Common common;
  std::string rule;      ///< FILE:RULE; RULE or MODULE:RULE of a plugin
  std::string plugin;    ///< empty: none
  unsigned threads = 0;  ///< at most so many; 0: as many as the machine runs at once
};
int apply(ApplyOptions const& options);
/// Of a rule of a plugin.
int apply_plugin(ApplyOptions const& options);

struct RunOptions : ChangeOptions {
  Common common;
  std::string operation;  ///< FILE:OPERATION
};
int run(RunOptions const& options);

struct InfoOptions {
  std::string mesh;  ///< or a plugin
  std::string model = "gmap";  ///< for surface formats: gmap, omap, dual_omap, closed_gmap
  bool stats_json = false;
};
int info(InfoOptions const& options);
/// Of a plugin.
int info_plugin(InfoOptions const& options);

struct FormatOptions {
  Common common;
  std::vector<std::string> files;
  bool check = false;
};
int format(FormatOptions const& options);

struct ImportOptions {
  Common common;
  std::string file;    ///< a modeler of Jerboa, .jme
  std::string output;  ///< -o, a folder or a .jrule file; empty: standard output
};
int import_jerboa(ImportOptions const& options);

struct ExplainOptions {
  Common common;
  std::string what;  ///< a code, FILE:RULE or FILE; empty: list all codes
  std::optional<int> dimension;  ///< the n of a rule on `gmap(n)`
  bool json = false;             ///< of rules
};
int explain(ExplainOptions const& options);
/// Of rules: what they do to cells.
int explain_rule(ExplainOptions const& options);

/// Commands that are documented but not built yet: says so, with a code.
int not_implemented(std::string const& command);

}  // namespace jrule::driver
