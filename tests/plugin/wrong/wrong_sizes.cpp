// A plugin of this version that says that its rules have another size.
#include <jrule/plugin.h>

extern "C" {
extern jrule_plugin const jrule_plugin_entry;
jrule_plugin const jrule_plugin_entry = [] {
  jrule_plugin entry{};
  entry.abi_version = JRULE_PLUGIN_ABI_VERSION;
  entry.struct_size = sizeof(jrule_plugin);
  entry.error_size = sizeof(jrule_error);
  entry.value_size = sizeof(jrule_value);
  entry.embedding_size = sizeof(jrule_embedding);
  entry.modeler_size = sizeof(jrule_modeler);
  entry.hook_size = sizeof(jrule_hook);
  entry.parameter_size = sizeof(jrule_parameter);
  entry.node_size = sizeof(jrule_node);
  entry.rule_size = sizeof(jrule_rule) + 8;
  entry.summary_size = sizeof(jrule_summary);
  entry.progress_size = sizeof(jrule_progress);
  return entry;
}();
}
