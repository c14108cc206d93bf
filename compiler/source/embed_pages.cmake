# cmake -DFOLDER=explain -DNUMBERS=J0001,J0002 -DOUTPUT=pages.cpp -P embed_pages.cmake
# Writes a C++ file with the text of FOLDER/<number>.md for each number.
string(REPLACE "," ";" numbers "${NUMBERS}")
set(table "")
foreach(number IN LISTS numbers)
  file(READ "${FOLDER}/${number}.md" text)
  string(FIND "${text}" ")page\"" delimiter)
  if(NOT delimiter EQUAL -1)
    message(FATAL_ERROR "${number}.md contains the text that ends the C++ literal it is embedded in")
  endif()
  string(APPEND table "    {\"${number}\", R\"page(${text})page\"},\n")
endforeach()
file(WRITE "${OUTPUT}" "// Generated from explain/*.md by embed_pages.cmake.
#include \"compiler/source/pages.h\"

namespace jrule::source {

std::vector<Page> const& pages() {
  static std::vector<Page> const all{
${table}  };
  return all;
}

}  // namespace jrule::source
")
