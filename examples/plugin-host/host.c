/* host LIB                            lists what a plugin offers
 * host LIB RULE IN OUT [DART ...]     applies a rule: at these darts, one for each hook; without any, everywhere */
#include <dlfcn.h>
#include <jrule/plugin.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MAX_DARTS = 16, MAX_ARGUMENTS = 32 };

/* The entry, or null after saying why. Nothing of it is read before its version is known. */
static jrule_plugin const* load(char const* path) {
  jrule_plugin const* plugin;
  void* library = dlopen(path, RTLD_NOW | RTLD_LOCAL);
  if (library == NULL) {
    fprintf(stderr, "host: %s\n", dlerror());
    return NULL;
  }
  plugin = (jrule_plugin const*)dlsym(library, JRULE_PLUGIN_ENTRY);
  if (plugin == NULL) {
    fprintf(stderr, "host: %s is no plugin\n", path);
    return NULL;
  }
  if (plugin->abi_version != JRULE_PLUGIN_ABI_VERSION || plugin->struct_size < sizeof(jrule_plugin) ||
      plugin->error_size != sizeof(jrule_error) || plugin->value_size != sizeof(jrule_value) ||
      plugin->embedding_size != sizeof(jrule_embedding) || plugin->modeler_size != sizeof(jrule_modeler) ||
      plugin->hook_size != sizeof(jrule_hook) || plugin->parameter_size != sizeof(jrule_parameter) ||
      plugin->node_size != sizeof(jrule_node) || plugin->rule_size != sizeof(jrule_rule) ||
      plugin->summary_size != sizeof(jrule_summary) || plugin->progress_size != sizeof(jrule_progress)) {
    fprintf(stderr, "host: %s is a plugin of another version\n", path);
    return NULL;
  }
  return plugin;
}

static void list(jrule_plugin const* plugin) {
  uint32_t r, i;
  for (r = 0; r < plugin->rule_count; ++r) {
    jrule_rule const* rule = &plugin->rules[r];
    printf("%s(", rule->name);
    for (i = 0; i < rule->hook_count; ++i)
      printf("%s%s %s", i == 0 ? "" : ", ", rule->hooks[i].name, rule->hooks[i].orbit);
    for (i = 0; i < rule->parameter_count; ++i) printf("; %s [%s]", rule->parameters[i].name, rule->parameters[i].unit);
    printf(")  %s\n", rule->doc);
  }
}

static int32_t show_progress(void* user, double done) {
  int* last = (int*)user;
  int const percent = (int)(100 * done);
  if (percent >= *last + 50 || percent == 100) {
    printf("%d %%\n", percent);
    *last = percent;
  }
  return 0; /* go on */
}

static int failed(jrule_error const* error) {
  if (error->file[0] != '\0') fprintf(stderr, "%s:%lu: ", error->file, (unsigned long)error->line);
  fprintf(stderr, "%s\n", error->message);
  return 1;
}

static int apply(jrule_plugin const* plugin, uint32_t number, char const* in, char const* out, int dart_count,
                 char** darts) {
  jrule_rule const* rule = &plugin->rules[number];
  jrule_value arguments[MAX_ARGUMENTS];
  jrule_dart hooks[MAX_DARTS];
  jrule_error error;
  jrule_summary summary;
  jrule_map* map = NULL;
  int32_t code;
  int i;
  if (dart_count > MAX_DARTS || rule->parameter_count > MAX_ARGUMENTS) {
    fprintf(stderr, "host: too many darts or parameters\n");
    return 2;
  }
  memset(arguments, 0, sizeof arguments);
  for (i = 0; i < MAX_ARGUMENTS; ++i) arguments[i].type = JRULE_DEFAULT;
  for (i = 0; i < dart_count; ++i) hooks[i] = (jrule_dart)strtoul(darts[i], NULL, 10);

  if (plugin->read(rule->modeler, in, &map, &error) != JRULE_OK) return failed(&error);
  if (dart_count > 0 || rule->hook_count == 0) {
    code = plugin->apply(map, number, hooks, (uint32_t)dart_count, arguments, rule->parameter_count, NULL, 0, &error);
  } else {
    int last = 0;
    jrule_progress progress;
    progress.report = show_progress;
    progress.user = &last;
    code = plugin->apply_everywhere(map, number, arguments, rule->parameter_count, &progress, &error);
  }
  if (code == JRULE_OK) code = plugin->write(map, out, &error);
  if (code == JRULE_OK) code = plugin->summarize(map, &summary, &error);
  plugin->destroy(map);
  if (code != JRULE_OK) return failed(&error);
  printf("%lu vertices, %lu edges, %lu faces\n", (unsigned long)summary.cells[0], (unsigned long)summary.cells[1],
         (unsigned long)summary.cells[2]);
  return 0;
}

int main(int argc, char** argv) {
  jrule_plugin const* plugin;
  uint32_t r;
  if (argc != 2 && argc < 5) {
    fprintf(stderr, "usage: host LIB [RULE IN OUT [DART ...]]\n");
    return 2;
  }
  plugin = load(argv[1]);
  if (plugin == NULL) return 2;
  if (argc == 2) {
    list(plugin);
    return 0;
  }
  for (r = 0; r < plugin->rule_count; ++r) {
    if (strcmp(plugin->rules[r].name, argv[2]) == 0) return apply(plugin, r, argv[3], argv[4], argc - 5, argv + 5);
  }
  fprintf(stderr, "host: no rule is called %s\n", argv[2]);
  return 2;
}
