#!/usr/bin/env python3
"""host.py LIB                            lists what a plugin offers
host.py LIB RULE IN OUT [DART ...]     applies a rule: at these darts, one for each hook; without any, everywhere

The structs are those of jrule/plugin.h, in its order. Nothing but Python is needed.
"""
import ctypes as c
import os
import sys

ABI_VERSION = 1
OK, DEFAULT = 0, -1
TYPES = ["Bool", "Int", "Real", "Vec2", "Vec3", "Point2", "Point3", "Color", "extern"]


class Error(c.Structure):
    _fields_ = [("code", c.c_int32), ("line", c.c_uint32), ("file", c.c_char * 512), ("message", c.c_char * 1024)]


class Value(c.Structure):
    _fields_ = [("type", c.c_int32), ("unused", c.c_uint32), ("integer", c.c_int64), ("numbers", c.c_double * 3)]


class Embedding(c.Structure):
    _fields_ = [("name", c.c_char_p), ("doc", c.c_char_p), ("orbit", c.c_char_p), ("type", c.c_int32),
                ("default_kind", c.c_int32), ("default_value", Value)]


class Modeler(c.Structure):
    _fields_ = [("name", c.c_char_p), ("module", c.c_char_p), ("doc", c.c_char_p), ("model", c.c_char_p),
                ("dimension", c.c_int32), ("embedding_count", c.c_uint32), ("embeddings", c.POINTER(Embedding))]


class Hook(c.Structure):
    _fields_ = [("name", c.c_char_p), ("doc", c.c_char_p), ("orbit", c.c_char_p)]


class Parameter(c.Structure):
    _fields_ = [("name", c.c_char_p), ("doc", c.c_char_p), ("unit", c.c_char_p), ("type", c.c_int32),
                ("default_kind", c.c_int32), ("default_value", Value)]


class Node(c.Structure):
    _fields_ = [("name", c.c_char_p), ("doc", c.c_char_p)]


class Rule(c.Structure):
    _fields_ = [("name", c.c_char_p), ("module", c.c_char_p), ("doc", c.c_char_p), ("not_callable", c.c_char_p),
                ("modeler", c.c_uint32), ("hook_count", c.c_uint32), ("hooks", c.POINTER(Hook)),
                ("parameter_count", c.c_uint32), ("node_count", c.c_uint32), ("parameters", c.POINTER(Parameter)),
                ("nodes", c.POINTER(Node))]


class Summary(c.Structure):
    _fields_ = [("darts", c.c_uint64), ("cells", c.c_uint64 * 10), ("components", c.c_uint64), ("euler", c.c_int64),
                ("boundary_darts", c.c_uint64), ("orientable", c.c_int32), ("valid", c.c_int32)]


Report = c.CFUNCTYPE(c.c_int32, c.c_void_p, c.c_double)


class Progress(c.Structure):
    _fields_ = [("report", Report), ("user", c.c_void_p)]


def function(*arguments):
    return c.CFUNCTYPE(c.c_int32, *arguments)


MAP, DART, INT, COUNT, ERROR = c.c_void_p, c.c_uint32, c.c_int32, c.c_uint32, c.POINTER(Error)
DARTS, VALUES, MAPS = c.POINTER(DART), c.POINTER(Value), c.POINTER(c.c_void_p)


class Plugin(c.Structure):
    _fields_ = [("abi_version", c.c_uint32), ("struct_size", c.c_uint32)] + [
        (name + "_size", c.c_uint32)
        for name in ("error", "value", "embedding", "modeler", "hook", "parameter", "node", "rule", "summary", "progress")
    ] + [
        ("name", c.c_char_p), ("modeler_count", c.c_uint32), ("rule_count", c.c_uint32),
        ("modelers", c.POINTER(Modeler)), ("rules", c.POINTER(Rule)),
        ("create", function(COUNT, MAPS, ERROR)),
        ("read", function(COUNT, c.c_char_p, MAPS, ERROR)),
        ("copy", function(MAP, MAPS, ERROR)),
        ("write", function(MAP, c.c_char_p, ERROR)),
        ("destroy", c.CFUNCTYPE(None, MAP)),
        ("apply", function(MAP, COUNT, DARTS, COUNT, VALUES, COUNT, DARTS, COUNT, ERROR)),
        ("apply_everywhere", function(MAP, COUNT, VALUES, COUNT, c.POINTER(Progress), ERROR)),
        ("modeler_of", function(MAP, c.POINTER(COUNT), ERROR)),
        ("summarize", function(MAP, c.POINTER(Summary), ERROR)),
        ("count_darts", function(MAP, c.POINTER(COUNT), c.POINTER(COUNT), ERROR)),
        ("contains", function(MAP, DART, c.POINTER(INT), ERROR)),
        ("target", function(MAP, DART, INT, DARTS, ERROR)),
        ("source", function(MAP, DART, INT, DARTS, ERROR)),
        ("cells", function(MAP, INT, DARTS, COUNT, c.POINTER(COUNT), ERROR)),
        ("orbit", function(MAP, DART, c.POINTER(INT), COUNT, DARTS, COUNT, c.POINTER(COUNT), ERROR)),
        ("value", function(MAP, COUNT, DART, VALUES, ERROR)),
        ("set_value", function(MAP, COUNT, DART, VALUES, ERROR)),
    ]


SIZES = {"error": Error, "value": Value, "embedding": Embedding, "modeler": Modeler, "hook": Hook, "parameter": Parameter,
         "node": Node, "rule": Rule, "summary": Summary, "progress": Progress}


class Refused(Exception):
    """What the plugin says that is wrong."""


def load(path):
    library = c.CDLL(os.path.abspath(path))
    try:
        start = (c.c_uint32 * 2).in_dll(library, "jrule_plugin_entry")
    except ValueError:
        raise Refused(path + " is no plugin")
    if start[0] != ABI_VERSION or start[1] < c.sizeof(Plugin):
        raise Refused(path + " is a plugin of another version")
    plugin = Plugin.in_dll(library, "jrule_plugin_entry")
    if any(getattr(plugin, name + "_size") != c.sizeof(struct) for name, struct in SIZES.items()):
        raise Refused(path + " is a plugin of another version")
    return plugin


def call(plugin, name, *arguments):
    error = Error()
    if getattr(plugin, name)(*arguments, c.byref(error)) != OK:
        place = "{}:{}: ".format(error.file.decode(), error.line) if error.file else ""
        raise Refused(place + error.message.decode())


def signature(rule):
    hooks = ["{} {}".format(rule.hooks[i].name.decode(), rule.hooks[i].orbit.decode()) for i in range(rule.hook_count)]
    parameters = ["{}: {}".format(rule.parameters[i].name.decode(), TYPES[rule.parameters[i].type])
                  for i in range(rule.parameter_count)]
    return "{}({})".format(rule.name.decode(), ", ".join(hooks + parameters))


def positions(plugin, rule, handle):
    """The values of the first embedding, of points on vertices, at each vertex: what a modeler would draw."""
    count = COUNT()
    call(plugin, "cells", handle, 0, None, 0, c.byref(count))
    darts = (DART * count.value)()
    call(plugin, "cells", handle, 0, darts, count, c.byref(count))
    value = Value()
    points = []
    for dart in darts:
        call(plugin, "value", handle, 0, dart, c.byref(value))
        points.append(tuple(value.numbers))
    return points


def apply(plugin, number, source, target, darts):
    rule = plugin.rules[number]
    handle = c.c_void_p()
    call(plugin, "read", rule.modeler, os.fsencode(source), c.byref(handle))
    try:
        arguments = (Value * rule.parameter_count)(*[Value(type=DEFAULT) for _ in range(rule.parameter_count)])
        if darts or rule.hook_count == 0:
            call(plugin, "apply", handle, number, (DART * len(darts))(*darts), len(darts), arguments,
                 rule.parameter_count, None, 0)
        else:
            reports = []
            # The callback has to live as long as the call.
            progress = Progress(Report(lambda user, done: reports.append(done) or 0), None)
            call(plugin, "apply_everywhere", handle, number, arguments, rule.parameter_count, c.byref(progress))
            print("{} reports of progress, the last {:.0%}".format(len(reports), reports[-1]))
        call(plugin, "write", handle, os.fsencode(target))
        summary = Summary()
        call(plugin, "summarize", handle, c.byref(summary))
        print("{} vertices, {} edges, {} faces".format(*summary.cells[:3]))
        print("from {} to {}".format(min(positions(plugin, rule, handle)), max(positions(plugin, rule, handle))))
    finally:
        plugin.destroy(handle)


def main(words):
    if len(words) != 1 and len(words) < 4:
        print(__doc__, file=sys.stderr)
        return 2
    plugin = load(words[0])
    names = [plugin.rules[r].name.decode() for r in range(plugin.rule_count)]
    if len(words) == 1:
        for r in range(plugin.rule_count):
            print(signature(plugin.rules[r]) + "  " + plugin.rules[r].doc.decode())
        return 0
    if words[1] not in names:
        raise Refused("no rule is called " + words[1])
    apply(plugin, names.index(words[1]), words[2], words[3], [int(word) for word in words[4:]])
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except (Refused, OSError) as refused:
        print("host.py:", refused, file=sys.stderr)
        sys.exit(1)
