/* Rules and operations as a shared library that a program in any language can load: plain C, one exported symbol.
 *
 * A host loads the library, looks up the object `jrule_plugin_entry`, a const jrule_plugin, and reads its first two
 * fields. If `abi_version` is not JRULE_PLUGIN_ABI_VERSION, or `struct_size` is less than sizeof(jrule_plugin), it
 * reads nothing else. The sizes that follow have to be equal to those of its own structs. Within one version the entry
 * may grow at its end.
 *
 * Everything that the entry leads to is constant and valid while the library is loaded; no text is null, but where it
 * says so, and all are UTF-8. Functions may be called from several threads, but on one map by one of them at a time.
 * They never end the program and throw nothing: they return JRULE_OK, or another code that says why nothing was done.
 * Whenever a function fails, the map is as it was, and what its other pointers lead to is not written. What they do
 * check: null pointers, numbers out of range, and maps of another library. What they cannot check: that a pointer leads
 * to as much memory as is said, and that a map has not been destroyed.
 */
#ifndef JRULE_PLUGIN_H
#define JRULE_PLUGIN_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define JRULE_PLUGIN_ABI_VERSION 1u
/* The name of the exported object. */
#define JRULE_PLUGIN_ENTRY "jrule_plugin_entry"

/* ---- Errors ---- */

enum {
  JRULE_OK = 0,
  JRULE_NOT_APPLICABLE = 1, /* the rule does not match there, or the operation fails */
  JRULE_BAD_INPUT = 2,      /* what a file holds */
  JRULE_IO = 3,             /* a file cannot be read or written */
  JRULE_NO_MEMORY = 4,
  JRULE_BAD_ARGUMENT = 5, /* of the function that was called */
  JRULE_CANCELLED = 6,    /* the host's `report` asked for it */
  JRULE_THROWN = 7,       /* C++ code that the rules call from outside threw an exception */
  JRULE_LIMIT = 8         /* operations call each other too deeply */
};

/* Belongs to the caller. Every function takes a null pointer instead. */
typedef struct jrule_error {
  int32_t code;
  uint32_t line;      /* 1-based line in `file`; 0: none */
  char file[512];     /* the file that it is about; empty: none */
  char message[1024]; /* lower case, no full stop; cut off if it is longer. Empty after JRULE_OK */
} jrule_error;

/* ---- Values ---- */

enum {
  JRULE_BOOL = 0,
  JRULE_INT = 1,
  JRULE_REAL = 2,
  JRULE_VEC2 = 3,
  JRULE_VEC3 = 4,
  JRULE_POINT2 = 5,
  JRULE_POINT3 = 6,
  JRULE_COLOR = 7,
  JRULE_EXTERN = 8,  /* a C++ type from outside: the value of an embedding that only C++ can read */
  JRULE_DEFAULT = -1 /* as an argument: the parameter's default */
};

typedef struct jrule_value {
  int32_t type;
  uint32_t unused;
  int64_t integer;   /* of Bool (0 or 1) and Int */
  double numbers[3]; /* of all others: as many as they have components, finite ones; colours are red, green, blue */
} jrule_value;

/* ---- What a plugin offers ---- */

enum {
  JRULE_NO_DEFAULT = 0,
  JRULE_VALUE_DEFAULT = 1,   /* it is in `default_value` */
  JRULE_COMPUTED_DEFAULT = 2 /* C++ from outside computes it */
};

/* Values on the cells or other orbits of a map. */
typedef struct jrule_embedding {
  char const* name;
  char const* doc;   /* empty: none; the same below */
  char const* orbit; /* "<1,2>" */
  int32_t type;
  int32_t default_kind;
  jrule_value default_value;
} jrule_embedding;

/* A kind of map. */
typedef struct jrule_modeler {
  char const* name;
  char const* module; /* whose rule file declares it; empty: it is a model without embeddings, which none declares */
  char const* doc;
  char const* model; /* "gmap", "omap", or the name of a model of the user's */
  int32_t dimension;
  uint32_t embedding_count;
  jrule_embedding const* embeddings;
} jrule_modeler;

/* A dart that a rule is given. */
typedef struct jrule_hook {
  char const* name;
  char const* doc;
  char const* orbit; /* whose dart it is: "<0,1>" */
} jrule_hook;

typedef struct jrule_parameter {
  char const* name;
  char const* doc;
  char const* unit; /* "m"; empty: none */
  int32_t type;
  int32_t default_kind;
  jrule_value default_value;
} jrule_parameter;

/* A dart that applying a rule gives: one that it has kept or added. */
typedef struct jrule_node {
  char const* name;
  char const* doc;
} jrule_node;

typedef struct jrule_rule {
  char const* name;   /* "cone", "sew[2]" */
  char const* module; /* the rule file's name: two modules may have rules of one name */
  char const* doc;
  char const* not_callable; /* why it cannot be applied from here; null: it can */
  uint32_t modeler;         /* its place in `modelers` */
  uint32_t hook_count;
  jrule_hook const* hooks;
  uint32_t parameter_count;
  uint32_t node_count;
  jrule_parameter const* parameters;
  jrule_node const* nodes;
} jrule_rule;

/* ---- Maps ---- */

typedef uint32_t jrule_dart;
#define JRULE_NO_DART 0xffffffffu

typedef struct jrule_map jrule_map;

typedef struct jrule_summary {
  uint64_t darts;
  uint64_t cells[10]; /* by dimension */
  uint64_t components;
  int64_t euler;
  uint64_t boundary_darts; /* darts whose arc of the highest dimension is a loop */
  int32_t orientable;
  int32_t valid; /* is it a map of its model, with a value on each orbit? */
} jrule_summary;

/* How far an application has come. */
typedef struct jrule_progress {
  /* `done` rises from 0 to 1. Gives 0 to go on; anything else cancels. What it gives at 1, when all is done, does not
   * matter. It must not use the map. */
  int32_t (*report)(void* user, double done);
  void* user;
} jrule_progress;

/* ---- The entry ---- */

typedef struct jrule_plugin {
  uint32_t abi_version;
  uint32_t struct_size;
  uint32_t error_size, value_size, embedding_size, modeler_size, hook_size, parameter_size, node_size, rule_size,
      summary_size, progress_size;

  char const* name;
  uint32_t modeler_count;
  uint32_t rule_count;
  jrule_modeler const* modelers;
  jrule_rule const* rules;

  /* A new map, which destroy() ends: an empty one, the content of a file (.obj .off .ply .stl .jmap), a copy. */
  int32_t (*create)(uint32_t modeler, jrule_map** map, jrule_error* error);
  int32_t (*read)(uint32_t modeler, char const* path, jrule_map** map, jrule_error* error);
  int32_t (*copy)(jrule_map const* map, jrule_map** other, jrule_error* error);
  /* In the format of the path's suffix; the file appears whole or not at all. */
  int32_t (*write)(jrule_map const* map, char const* path, jrule_error* error);
  /* A null pointer is left alone. */
  void (*destroy)(jrule_map* map);

  /* Applies a rule: at one dart for each hook, with one argument for each parameter, in their order. `darts` gets one
   * dart for each node of the rule, and has room for `capacity`; null with 0: they are not wanted. Whatever a rule
   * deletes, other darts keep their numbers. */
  int32_t (*apply)(jrule_map* map, uint32_t rule, jrule_dart const* hooks, uint32_t hook_count,
                   jrule_value const* arguments, uint32_t argument_count, jrule_dart* darts, uint32_t capacity,
                   jrule_error* error);
  /* Applies a rule of one hook at each orbit where it is applicable; fails if there are orbits, but none where it is.
   * Where rules are applied at all orbits at once, progress is reported before and after; else before each orbit and
   * after the last, and it works on a copy. `progress` may be null. */
  int32_t (*apply_everywhere)(jrule_map* map, uint32_t rule, jrule_value const* arguments, uint32_t argument_count,
                              jrule_progress const* progress, jrule_error* error);

  /* Which of `modelers` the map is of. */
  int32_t (*modeler_of)(jrule_map const* map, uint32_t* modeler, jrule_error* error);
  int32_t (*summarize)(jrule_map const* map, jrule_summary* summary, jrule_error* error);
  /* How many darts there are, and a number that is greater than each. O(1). Either pointer may be null. */
  int32_t (*count_darts)(jrule_map const* map, uint32_t* count, uint32_t* limit, jrule_error* error);
  /* Is there a dart of that number? 1 or 0. */
  int32_t (*contains)(jrule_map const* map, jrule_dart dart, int32_t* is_there, jrule_error* error);
  /* Where the arc of that dimension leads to, and where the one that arrives comes from. */
  int32_t (*target)(jrule_map const* map, jrule_dart dart, int32_t dimension, jrule_dart* to, jrule_error* error);
  int32_t (*source)(jrule_map const* map, jrule_dart dart, int32_t dimension, jrule_dart* from, jrule_error* error);
  /* The smallest dart of each cell of that dimension, ascending. `count` is how many there are, of which the first
   * `capacity` are written: ask with null and 0 for the room that it takes. */
  int32_t (*cells)(jrule_map const* map, int32_t dimension, jrule_dart* darts, uint32_t capacity, uint32_t* count,
                   jrule_error* error);
  /* The darts that arcs of these dimensions lead to from `dart`, that one first, depth first: with the two dimensions
   * of a closed face, in the order of its boundary. `darts`, `capacity` and `count` are those of cells(). */
  int32_t (*orbit)(jrule_map const* map, jrule_dart dart, int32_t const* dimensions, uint32_t dimension_count,
                   jrule_dart* darts, uint32_t capacity, uint32_t* count, jrule_error* error);
  /* The value of the dart's orbit; `embedding` is its place in the modeler's. */
  int32_t (*value)(jrule_map const* map, uint32_t embedding, jrule_dart dart, jrule_value* value, jrule_error* error);
  int32_t (*set_value)(jrule_map* map, uint32_t embedding, jrule_dart dart, jrule_value const* value,
                       jrule_error* error);

  /* From this one on, the `rules` are operations: programs that chain rules. Their `hooks` are the parameters that are
   * darts, in their order, with "<>" as their orbit; they have one node, `result`, if they give a dart, and else none.
   * apply() runs them too; apply_everywhere() does not. */
  uint32_t first_operation;
  /* The same as apply() for operations, with progress: `report` is asked before each application of a rule, `done` being
   * 0 all the while, as nobody knows how many there will be. `progress` may be null. */
  int32_t (*run)(jrule_map* map, uint32_t operation, jrule_dart const* darts, uint32_t dart_count,
                 jrule_value const* arguments, uint32_t argument_count, jrule_progress const* progress,
                 jrule_dart* results, uint32_t capacity, jrule_error* error);
} jrule_plugin;

#ifdef __cplusplus
}
#endif

#endif
