#include "compiler/backend/cpp/names.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace jrule::cpp {

namespace {

constexpr auto keywords = std::to_array<std::string_view>({
    "alignas",     "alignof",  "and",        "and_eq",    "asm",       "auto",         "bitand",
    "bitor",       "bool",     "break",      "case",      "catch",     "char",         "char16_t",
    "char32_t",    "char8_t",  "class",      "co_await",  "co_return", "co_yield",     "compl",
    "concept",     "const",    "const_cast", "consteval", "constexpr", "constinit",    "continue",
    "decltype",    "default",  "delete",     "do",        "double",    "dynamic_cast", "else",
    "enum",        "explicit", "export",     "extern",    "false",     "float",        "for",
    "friend",      "goto",     "if",         "inline",    "int",       "long",         "mutable",
    "namespace",   "new",      "noexcept",   "not",       "not_eq",    "nullptr",      "operator",
    "or",          "or_eq",    "private",    "protected", "public",    "register",     "reinterpret_cast",
    "requires",    "return",   "short",      "signed",    "sizeof",    "static",       "static_assert",
    "static_cast", "struct",   "switch",     "template",  "this",      "thread_local", "throw",
    "true",        "try",      "typedef",    "typeid",    "typename",  "union",        "unsigned",
    "using",       "virtual",  "void",       "volatile",  "wchar_t",   "while",        "xor",
    "xor_eq",
});

// Macros that compilers and the headers of the standard library define with ordinary names.
constexpr auto macros = std::to_array<std::string_view>({
    "BUFSIZ",   "CLOCKS_PER_SEC", "EDOM",     "EOF",     "ERANGE",     "EXIT_FAILURE", "EXIT_SUCCESS", "HUGE_VAL",
    "I",        "INFINITY",       "INT_MAX",  "INT_MIN", "MB_CUR_MAX", "NAN",          "NULL",         "RAND_MAX",
    "SEEK_CUR", "SEEK_END",       "SEEK_SET", "WEOF",    "assert",     "errno",        "i386",         "linux",
    "offsetof", "setjmp",         "stderr",   "stdin",   "stdout",     "unix",         "va_arg",       "va_copy",
    "va_end",   "va_start",
});

// Functions of the C library and of POSIX headers that C++ headers bring in: a namespace cannot have their names.
constexpr auto c_functions = std::to_array<std::string_view>({
    "abort",   "abs",       "access",     "acos",        "acosh",    "alarm",    "asin",      "asinh",     "atan",
    "atan2",   "atanh",     "atexit",     "atof",        "atoi",     "atol",     "atoll",     "bsearch",   "cbrt",
    "ceil",    "chdir",     "chown",      "clock",       "close",    "copysign", "cos",       "cosh",      "crypt",
    "ctime",   "daemon",    "difftime",   "div",         "dup",      "encrypt",  "erf",       "erfc",      "exit",
    "exp",     "exp2",      "expm1",      "fabs",        "fclose",   "fdim",     "feof",      "ferror",    "fflush",
    "fgetc",   "fgets",     "floor",      "fma",         "fmax",     "fmin",     "fmod",      "fopen",     "fork",
    "fprintf", "fputc",     "fputs",      "fread",       "free",     "freopen",  "frexp",     "fscanf",    "fseek",
    "fsync",   "ftell",     "fwrite",     "gamma",       "getc",     "getchar",  "getenv",    "getopt",    "gets",
    "gmtime",  "hypot",     "ilogb",      "index",       "isalnum",  "isalpha",  "iscntrl",   "isdigit",   "isgraph",
    "islower", "isprint",   "ispunct",    "isspace",     "isupper",  "isxdigit", "j0",        "j1",        "jn",
    "jrand48", "kill",      "labs",       "ldexp",       "ldiv",     "lgamma",   "link",      "llabs",     "lldiv",
    "llrint",  "llround",   "localeconv", "localtime",   "lockf",    "log",      "log10",     "log1p",     "log2",
    "logb",    "lrint",     "lround",     "lseek",       "main",     "malloc",   "mblen",     "memchr",    "memcmp",
    "memcpy",  "memmove",   "memset",     "mktime",      "modf",     "nan",      "nearbyint", "nice",      "open",
    "pause",   "perror",    "pipe",       "pow",         "printf",   "profil",   "putc",      "putchar",   "putenv",
    "puts",    "qsort",     "raise",      "rand",        "random",   "read",     "realloc",   "remainder", "remove",
    "rename",  "rewind",    "rindex",     "rint",        "rmdir",    "round",    "scalb",     "scanf",     "select",
    "setenv",  "setlocale", "signal",     "significand", "sin",      "sinh",     "sleep",     "sprintf",   "sqrt",
    "srand",   "sscanf",    "stat",       "stpcpy",      "strcat",   "strchr",   "strcmp",    "strcpy",    "strlen",
    "strncat", "strncmp",   "strstr",     "strtod",      "strtok",   "strtol",   "swab",      "symlink",   "sync",
    "syscall", "system",    "tan",        "tanh",        "tempnam",  "tgamma",   "time",      "timezone",  "tmpfile",
    "tmpnam",  "tolower",   "toupper",    "trunc",       "truncate", "ungetc",   "unlink",    "usleep",    "vfork",
    "wait",    "wcslen",    "write",      "y0",          "y1",       "yn",
});

static_assert(std::is_sorted(keywords.begin(), keywords.end()));
static_assert(std::is_sorted(macros.begin(), macros.end()));
static_assert(std::is_sorted(c_functions.begin(), c_functions.end()));

template <class Names>
bool contains(Names const& names, std::string_view name) {
  return std::binary_search(names.begin(), names.end(), name);
}

bool is_upper(char c) { return std::isupper(static_cast<unsigned char>(c)) != 0; }
bool is_alphanumeric(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; }

}  // namespace

std::string_view unusable(std::string_view name) {
  if (contains(keywords, name)) return "is a keyword of C++";
  if (contains(macros, name)) return "is a macro of the C++ library";
  if (name.find("__") != std::string_view::npos || (name.size() > 1 && name[0] == '_' && is_upper(name[1]))) {
    return "is reserved for C++ compilers";
  }
  return {};
}

std::string identifier(std::string_view text) {
  std::string name;
  for (char const c : text) {
    char const usable = is_alphanumeric(c) && static_cast<unsigned char>(c) < 128 ? c : '_';
    if (usable != '_' || name.empty() || name.back() != '_') name += usable;
  }
  if (!text.empty() && text.back() != '_' && name.back() == '_') name.pop_back();  // "sew[2]"
  if (name.empty() || name == "_" || std::isdigit(static_cast<unsigned char>(name[0])) != 0 ||
      (name.size() > 1 && name[0] == '_' && is_upper(name[1]))) {
    name.insert(0, "x");
  }
  if (!unusable(name).empty()) name += '_';
  return name;
}

std::string camel_case(std::string_view name) {
  std::string result;
  bool start = true;
  for (char const c : name) {
    if (c == '_') {
      start = true;
    } else {
      result += start ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
      start = false;
    }
  }
  return result;
}

std::string snake_case(std::string_view name) {
  std::string result;
  for (std::size_t i = 0; i < name.size(); ++i) {
    if (is_upper(name[i]) && i > 0 && name[i - 1] != '_' && !is_upper(name[i - 1])) result += '_';
    result += static_cast<char>(std::tolower(static_cast<unsigned char>(name[i])));
  }
  return result;
}

std::string namespace_of(std::string_view module) {
  std::size_t const dot = module.rfind('.');
  std::string name = identifier(dot == std::string_view::npos ? module : module.substr(dot + 1));
  if (name[0] == '_') name.insert(0, "x");  // reserved in the global namespace
  if (contains(c_functions, name) || name == "std" || name == "jrule" || name == "tl") name += '_';
  return name;
}

std::string Scope::take(std::string_view wanted) {
  std::string const base = identifier(wanted);
  std::string name = base;
  for (int count = 1; !reserve(name); ++count) {
    name = base + (base.back() == '_' ? "" : "_") + (count == 1 && base.back() != '_' ? "" : std::to_string(count));
  }
  return name;
}

}  // namespace jrule::cpp
